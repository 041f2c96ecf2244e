#include "core/error.h"
#include "core/known_names.h"
#include "core/printable.h"
#include "core/processes/shell.h"
#include "scene/depth_range.h"
#include "scene/load_file.h"
#include "scene/scene.h"
#include "scene/scene_bounds.h"
#include "scene/scene_digest.h"
#include "scene/scene_frame.h"
#include "scene/view_file.h"
#include "scene/view_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSceneFiles = "a .gltf, .glb, .obj, .fbx, .ply or .stl file";

std::string box_text(const Bounds& b) {
    return fmt::format("({:.3f}, {:.3f}, {:.3f}) to ({:.3f}, {:.3f}, {:.3f})", b.low.x, b.low.y, b.low.z,
                       b.high.x, b.high.y, b.high.z);
}

/// The view files that may be for this scene, the preferred one first.
std::vector<fs::path> possible_view_files(const Scene& scene, const LoadOptions& options) {
    if (!options.view_file.empty()) return {options.view_file};
    std::vector<fs::path> paths;
    if (!scene.file.empty()) paths.push_back(view_file_beside(scene.file));
    paths.push_back(view_file_path(scene.id));
    std::erase_if(paths, [](const fs::path& path) { return !fs::exists(path); });
    for (fs::path& path : view_files_of_stem(scene.id)) paths.push_back(std::move(path));
    return paths;
}

/// Brings the scene into the frame of a view file, by its unit and axes.
void take_frame(Scene& scene, const SceneFrame& frame, const std::string& view_file) {
    const bool is_turned = frame.y_up_from_file != glm::dmat3(1);
    if (frame.metres_per_unit == 1 && !is_turned) return;
    scene.warnings.push_back(
        fmt::format("{} knows this scene at another {}: its coordinates are taken times {}{} (as --unit and "
                    "--up can say)",
                    view_file, is_turned ? "scale or lying on its side" : "scale", frame.metres_per_unit,
                    is_turned ? ", and z is up" : ""));
    apply_frame(scene, frame);
    measure_scene(scene, scene.id);
}

/// The views of the first view file whose bounds match the scene's. Those of a file that the user names must.
std::vector<View> filed_views(Scene& scene, const LoadOptions& options) {
    for (const fs::path& path : possible_view_files(scene, options)) {
        ViewFile file = read_view_file(path);
        const std::string& name = file.views.front().source;
        if (const auto frame = recognise(file, scene.bounds, !options.metres_per_unit, !options.up)) {
            take_frame(scene, *frame, name);
            for (const View& view : file.views) {
                const std::string fault = view_fault(view.camera, scene.bounds);
                if (!fault.empty()) throw file_error(fault, fmt::format("{}: {}", name, view.id));
            }
            return std::move(file.views);
        }
        const std::string mismatch = fmt::format("is for a scene with bounds {}, this one has {}",
                                                 box_text(file.bounds), box_text(scene.bounds));
        if (!options.view_file.empty()) throw file_error(mismatch, name);
        scene.warnings.push_back(fmt::format("{} {}: its views are not used", name, mismatch));
    }
    return {};
}

/// Adds the usable cameras of the scene's file, under ids that `views` does not have.
void add_node_views(Scene& scene, std::vector<View>& views) {
    std::set<std::string> taken;
    for (const View& view : views) taken.insert(view.id);
    for (View& view : scene.views) {
        const std::string fault = view_fault(view.camera, scene.bounds);
        if (!fault.empty()) {
            scene.warnings.push_back(fmt::format("{} is left out: {}", view.source, fault));
            continue;
        }
        const std::string id = view.id;
        for (int n = 2; !taken.insert(view.id).second; ++n) view.id = fmt::format("{}_{}", id, n);
        views.push_back(std::move(view));
    }
}

std::string vector_words(const glm::dvec3& v) {
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

/// The user's own camera as a view.
View given_view(Camera camera, const Bounds& bounds) {
    // It is unknown which surfaces are close, but the camera looks at its target.
    constexpr double kNearPerDiagonal = 1e-3, kNearPerTarget = 1e-2;
    const double stated_near = std::min(kNearPerDiagonal * bounds.diagonal(),
                                        kNearPerTarget * glm::distance(camera.position, camera.target));
    const DepthRange range = useful_depth_range(camera, bounds, stated_near, 0);
    camera.near = range.near;
    camera.far = range.far;
    const std::string fault = view_fault(camera, bounds);
    if (!fault.empty()) throw usage_error(fault, "--eye");
    View view;
    view.id = "eye";
    view.camera = camera;
    view.kind = View::Kind::given;
    view.source = "the command line";
    view.options = fmt::format("--eye {} --target {} --fovy {}", vector_words(camera.position),
                               vector_words(camera.target), glm::degrees(camera.fovy_rad));
    return view;
}

/// All views but automatic ones, the preferred kinds first.
std::vector<View> stated_views(Scene& scene, const LoadOptions& options) {
    std::vector<View> views;
    if (options.camera) views.push_back(given_view(*options.camera, scene.bounds));
    for (View& view : filed_views(scene, options)) views.push_back(std::move(view));
    add_node_views(scene, views);
    return views;
}

/// Fills in the options that choose the view on a command line, and those that read the scene with its unit
/// and axes.
void name_options(View& view, const LoadOptions& options) {
    if (view.kind != View::Kind::given) {
        const bool is_named = view.kind == View::Kind::filed && !options.view_file.empty();
        view.options = (is_named ? "--views " + shell_quoted(options.view_file.string()) + " " : "") +
                       "--view " + shell_quoted(view.id);
    }
    view.options += frame_options(options);
}

/// Adds views, origin and digest, alike for built-in scenes and files. Bounds are measured already.
Scene finish(Scene scene, const LoadOptions& options) {
    scene.views = stated_views(scene, options);
    warn_of_unknown_unit(scene, options);
    move_origin(scene, suitable_origin(scene.bounds));
    for (View& view : scene.views) name_options(view, options);
    scene.digest = scene_digest(scene);
    return scene;
}

bool looks_like_path(const std::string& name) {
    return name.find('/') != std::string::npos || fs::path(name).has_extension();
}

}  // namespace

Scene load_scene(const std::string& name_or_path, const LoadOptions& options) {
    const std::vector<BuiltinScene>& builtins = builtin_scenes();
    if (const BuiltinScene* builtin = find_row(builtins, name_or_path)) {
        if (options.metres_per_unit || options.up)
            throw usage_error("a built-in scene is in metres with y up", "--unit, --up", "for files");
        Scene scene = builtin->generate();
        scene.id = name_or_path;
        measure_scene(scene, scene.id);
        return finish(std::move(scene), options);
    }
    std::error_code ec;
    if (!fs::exists(name_or_path, ec)) {
        if (looks_like_path(name_or_path)) throw file_error("no such file", name_or_path, kSceneFiles);
        throw unknown_name("no scene", name_or_path, ids_of(builtins), "SCENE",
                           fmt::format("or {}", kSceneFiles));
    }
    Scene scene = load_file(name_or_path, options);
    // The id names files, cells and lines: a file's name may hold characters that none of them can.
    scene.id = printable(fs::path(name_or_path).stem().string());
    return finish(std::move(scene), options);
}

}  // namespace aoscore
