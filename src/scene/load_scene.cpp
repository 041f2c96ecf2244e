#include "core/error.h"
#include "core/known_names.h"
#include "scene/automatic_view.h"
#include "scene/gltf/load_gltf.h"
#include "scene/scene.h"
#include "scene/scene_bounds.h"
#include "scene/scene_digest.h"
#include "scene/view_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

std::string box_text(const Bounds& b) {
    return fmt::format("({:.3f}, {:.3f}, {:.3f}) to ({:.3f}, {:.3f}, {:.3f})", b.low.x, b.low.y, b.low.z,
                       b.high.x, b.high.y, b.high.z);
}

/// Puts the view file's views before the scene's own, where the scene is the one they were made for.
void add_filed_views(Scene& scene) {
    const fs::path path = view_file_path(scene.id);
    if (!fs::exists(path)) return;
    ViewFile file = read_view_file(path);
    if (!bounds_match(file, scene.bounds)) {
        scene.warnings.push_back(
            fmt::format("{} is for a scene with bounds {}, this one has {}: its views are not used",
                        file.views.front().source, box_text(file.bounds), box_text(scene.bounds)));
        return;
    }
    std::set<std::string> taken;
    for (const View& view : file.views) taken.insert(view.id);
    for (View& view : scene.views) {
        const std::string id = view.id;
        for (int n = 2; !taken.insert(view.id).second; ++n) view.id = fmt::format("{}_{}", id, n);
        file.views.push_back(std::move(view));
    }
    scene.views = std::move(file.views);
}

/// What is the same for built-in scenes and files: views, origin, digest. Bounds are measured already.
Scene finish(Scene scene) {
    add_filed_views(scene);
    move_origin(scene, suitable_origin(scene.bounds));
    if (scene.views.empty()) scene.views.push_back(automatic_view(scene));
    scene.digest = scene_digest(scene);
    return scene;
}

bool looks_like_path(const std::string& name) {
    return name.find('/') != std::string::npos || fs::path(name).has_extension();
}

}  // namespace

Scene load_scene(const std::string& name_or_path, const LoadOptions& options) {
    const std::vector<BuiltinScene>& builtins = builtin_scenes();
    const auto builtin = std::find_if(builtins.begin(), builtins.end(),
                                      [&](const BuiltinScene& b) { return b.id == name_or_path; });
    if (builtin != builtins.end()) {
        Scene scene = builtin->generate();
        scene.id = name_or_path;
        measure_scene(scene, scene.id);
        return finish(std::move(scene));
    }
    std::error_code ec;
    if (!fs::exists(name_or_path, ec)) {
        if (looks_like_path(name_or_path))
            throw file_error("no such file", name_or_path, "a .gltf or .glb file");
        throw unknown_name("no scene", name_or_path, ids_of(builtins), "SCENE", "or a .gltf or .glb file");
    }
    Scene scene = gltf::load_gltf(name_or_path, options);
    scene.id = fs::path(name_or_path).stem().string();
    return finish(std::move(scene));
}

const View& find_view(const Scene& scene, std::string_view id) {
    for (const View& view : scene.views) {
        if (view.id == id) return view;
    }
    throw unknown_name(fmt::format("scene {} has no view", scene.id), id, ids_of(scene.views), "--view");
}

}  // namespace aoscore
