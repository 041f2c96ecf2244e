#include "scene/load_file.h"

#include "scene/gltf/load_gltf.h"
#include "scene/import/load_import.h"
#include "scene/scene_bounds.h"
#include "scene/scene_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

/// Loads a file of another program, in metres where the file or the user states its unit.
Scene load_import(const fs::path& path, imported::Format format, const LoadOptions& options) {
    imported::PlainScene plain = imported::load_import(path, format, options.albedo_textures);
    SceneFrame frame;
    frame.metres_per_unit =
        options.metres_per_unit.value_or(plain.metres_per_unit > 0 ? plain.metres_per_unit : 1);
    frame.y_up_from_file = options.up ? y_up_from(*options.up) : plain.y_up_from_file;
    apply_frame(plain.scene, frame);
    measure_scene(plain.scene, path.string());
    return std::move(plain.scene);
}

}  // namespace

Scene load_file(const fs::path& path, const LoadOptions& options) {
    if (const auto format = imported::format_of(path)) return load_import(path, *format, options);
    Scene scene = gltf::load_gltf(path, options);
    if (options.metres_per_unit || options.up) {
        apply_frame(scene, {options.metres_per_unit.value_or(1), y_up_from(options.up.value_or(UpAxis::y))});
        measure_scene(scene, path.string());
    }
    return scene;
}

void warn_of_unknown_unit(Scene& scene, const LoadOptions& options) {
    const auto format = imported::format_of(scene.file);
    const bool is_known = !format || *format == imported::Format::fbx || options.metres_per_unit ||
                          std::any_of(scene.views.begin(), scene.views.end(),
                                      [](const View& view) { return view.kind == View::Kind::filed; });
    if (is_known) return;
    const glm::dvec3 size = scene.bounds.high - scene.bounds.low;
    scene.warnings.push_back(fmt::format(
        "{} states no unit and no up axis: taken as metres{}, {:.4g} x {:.4g} x {:.4g} (see --unit, --up)",
        imported::format_name(*format), options.up ? "" : " with y up", size.x, size.y, size.z));
}

}  // namespace aoscore
