#pragma once

#include "core/memory_budget.h"
#include "importer/import_job.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace aoscore::importer {

/// A material's use of an image. Texture coordinates are the file's, v upwards.
struct TextureUse {
    std::string name;  ///< the image's name in the file; empty: none
    Texture::Wrap wrap_s = Texture::Wrap::repeat, wrap_t = Texture::Wrap::repeat;
    glm::vec2 scale{1}, offset{0};  ///< applied to the texture coordinates
    unsigned texcoord_set = 0;
    char channel = 'm';  ///< source of the opacity: r, g, b, l (luminance), or m: alpha where there is any,
                         ///< else luminance
};

/// The properties of a material of any format that matter here.
struct MaterialSource {
    std::string name;
    glm::vec3 color{1};
    float opacity = 1;  ///< 1 is solid
    TextureUse color_map, opacity_map;
};

/// Turns materials into those of a scene: texels that are less than half opaque become holes, as in a glTF
/// material of alpha mode MASK with a cut-off of 0.5. Images are read from the scene's folder.
class SurfaceMaterials {
  public:
    explicit SurfaceMaterials(ImportJob& job) : job_(job) {}

    /// Adds a material to the scene's, as the last one. Returns the use of its texture, whose texture
    /// coordinates its meshes need; nothing where they need none.
    std::optional<TextureUse> add(const MaterialSource& source);

    /// Call it after the last add(): it warns of all images that are not there.
    void finish();

    /// Finds the bytes of an image that the scene's file itself holds, by its name; nothing for another name.
    std::function<std::optional<std::string_view>(const std::string& name)> embedded;

  private:
    using Texels = Image<glm::u8vec4>;
    std::optional<std::string> bytes_of(const std::string& name) const;
    const Texels* image(const std::string& name);
    bool may_cut(const std::string& name);
    bool cuts_by_color_alpha(const MaterialSource& source);
    int add_texture(const TextureUse& use, Texels texels);

    ImportJob& job_;
    MemoryBudget budget_;
    std::map<std::string, std::optional<Texels>> images_;
    std::map<std::string, bool> may_cut_;
    std::set<std::string> missing_;
};

}  // namespace aoscore::importer
