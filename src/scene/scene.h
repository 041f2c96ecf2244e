#pragma once

#include "core/image.h"
#include "scene/camera.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Base-colour texels as stored (8 bits, sRGB-coded colour, linear alpha), row 0 at v = 0, with glTF's wrap
/// modes.
struct Texture {
    enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };
    Image<glm::u8vec4> texels;
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
};

/// The properties of a glTF material that matter here. A surface is never culled: every one is two-sided in
/// both paths.
struct Material {
    std::string name;
    glm::vec4 base_color{1};  ///< linear factor
    int texture = -1;         ///< index into Scene::textures; -1: none, or not needed
    /// Points whose alpha (factor x texture x vertices) is below this are holes, in both paths alike; 0 for
    /// solid surfaces. MASK uses its alphaCutoff, BLEND 0.5.
    float alpha_cutoff = 0;
    bool is_cutout() const { return alpha_cutoff > 0; }
};

/// One glTF primitive: triangles of one material in mesh space.
struct Mesh {
    std::vector<glm::vec3> positions;   ///< finite
    std::vector<glm::vec3> normals;     ///< unit, one a position; empty: geometric normals count
    std::vector<glm::vec2> texcoords;   ///< one a position; empty unless the material needs them
    std::vector<float> alphas;          ///< in [0,1], one a position; empty: 1, or not a cut-out
    std::vector<glm::uvec3> triangles;  ///< indices into positions, in range
    int material = 0;                   ///< index into Scene::materials
};

/// A mesh placed in the scene; meshes are shared by any number of instances.
struct Instance {
    int mesh = 0;
    /// The transform is affine; in double precision, so that a scene far from its origin keeps its details.
    glm::dmat4 scene_from_mesh{1.0};
    bool is_dynamic = false;  ///< it moves, as its file or generator says; here it is drawn at rest
};

struct Bounds {
    glm::dvec3 low{0}, high{0};
    glm::dvec3 centre() const { return (low + high) / 2.0; }
    double diagonal() const { return glm::length(high - low); }
};

/// A named fixed camera, with the radius that rankings use where nobody says another.
struct View {
    /// Where a view comes from, the preferred ones first: where nobody names a view, those of the first kind
    /// that a scene has are taken (see choose_views()).
    enum class Kind : std::uint8_t {
        given,      ///< the user's, by --eye
        filed,      ///< a view file's
        node,       ///< a camera of the scene's file
        automatic,  ///< found for a scene that has none of these
    };

    std::string id;
    Camera camera;
    std::optional<double> radius_m;  ///< the ranking's one AO radius in metres, as the view file states it
    Kind kind = Kind::filed;
    std::string source;   ///< "scenes/atrium/views.json", "camera node cam_wide" or "automatic"
    std::string note;     ///< such as "unverified: …"; empty when there is nothing to say
    std::string options;  ///< the words that choose it on a command line: "--view wide"
};

/// A scene ready for both paths. All coordinates (instances, bounds, cameras) are relative to `origin`, which
/// is zero unless the scene lies so far from its own origin that float32 would lose its details.
struct Scene {
    std::string id;              ///< the built-in's id, or the file's stem
    std::filesystem::path file;  ///< empty for built-in scenes
    std::vector<Texture> textures;
    std::vector<Material> materials;  ///< at least one
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<View> views;            ///< by kind, the preferred ones first; none is automatic
    glm::dvec3 origin{0};               ///< world coordinates of this struct's zero
    Bounds bounds;                      ///< box around all instances, relative to origin
    std::size_t triangle_count = 0;     ///< of all instances together
    std::vector<std::string> warnings;  ///< things ignored or repaired, one line each
    std::string digest;                 ///< see scene_digest()
};

/// The axis of a file's coordinates that is up.
enum class UpAxis : std::uint8_t { y, z };

struct LoadOptions {
    /// Decode base-colour textures of opaque materials as well; without it only cut-outs are decoded, since
    /// occlusion needs no more.
    bool albedo_textures = false;
    /// A view file to use in place of those that are found; empty: none.
    std::filesystem::path view_file;
    /// A camera of the user's own, in world coordinates; near and far are chosen for the scene.
    std::optional<Camera> camera;

    /// Metres for one unit of the file; empty: as a view file recognises it, else as the file states it, else
    /// 1.
    std::optional<double> metres_per_unit;
    /// The file's axis that is up; empty: as a view file recognises it, else as the file states it, else y.
    std::optional<UpAxis> up;

    bool operator==(const LoadOptions&) const = default;
};

/// Loads a built-in scene by id, or a file (.gltf, .glb, .obj, .fbx, .ply, .stl) by path. Views come from the
/// first view file whose bounds match, which may also tell the file's unit: LoadOptions::view_file,
/// NAME.views.json beside the file NAME.glb, scenes/<id>/views.json for the id, the file's stem or one of the
/// view file's own; then from the file's cameras. It makes no automatic views: the room framing does. Throws
/// usage_error for an unknown name (listing the known ones) and for a camera that cannot be used on this
/// scene, file_error for a bad file.
Scene load_scene(const std::string& name_or_path, const LoadOptions& options = {});

/// The view of that id. Throws usage_error listing the scene's views.
const View& find_view(const Scene& scene, std::string_view id);

struct BuiltinScene {
    std::string_view id;
    std::string_view description;
    Scene (*generate)();  ///< deterministic; leaves views, bounds, counts and digest to load_scene()
};
/// The one table of built-in scenes.
const std::vector<BuiltinScene>& builtin_scenes();

/// Alpha (factor x texture: level 0, bilinear, glTF wrap modes; x the vertices', interpolated) at `uv`, in
/// [0,1]. Both paths cut by it: shaders/contract/ holds the same function for the rasteriser.
float alpha_at(const Scene& scene, const Material& material, const glm::vec2& uv, float vertex_alpha = 1);

/// The geometric normal of a triangle in scene space: unit, by its winding; zero for a degenerate triangle.
glm::dvec3 triangle_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace aoscore
