#include "cli/shared_options.h"

#include "core/known_names.h"
#include "core/text.h"
#include "reference/cache/truth_cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

std::optional<int> parse_int(const std::string& text) {
    int value = 0;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (ec != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

double parse_radius(const std::string& text) {
    if (text == "inf") return std::numeric_limits<double>::infinity();
    double value = 0;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (ec != std::errc() || end != text.data() + text.size() || !(value > 0) || !std::isfinite(value)) {
        throw CLI::ValidationError("--radius",
                                   "\"" + text + "\" is no length in metres above 0, and not \"inf\"");
    }
    return value;
}

}  // namespace

void add_size_option(CLI::App& app, ImageSize& size) {
    app.add_option_function<std::string>(
           "--size",
           [&size](const std::string& text) {
               const auto x = text.find('x');
               const auto width = parse_int(text.substr(0, x));
               const auto height = x == std::string::npos ? std::nullopt : parse_int(text.substr(x + 1));
               if (!width || !height || *width < 1 || *height < 1 || *width > kLargestImageSide_px ||
                   *height > kLargestImageSide_px) {
                   throw CLI::ValidationError("--size",
                                              "\"" + text + "\" is no size such as 1920x1080 (at most " +
                                                  std::to_string(kLargestImageSide_px) + " each way)");
               }
               size = {*width, *height};
           },
           fmt::format("Image size in pixels [{}x{}]", size.width, size.height))
        ->type_name("WxH");
}

CLI::Validator one_of(const std::vector<std::string>& names) {
    return {[names](const std::string& value) -> std::string {
                if (std::find(names.begin(), names.end(), value) != names.end()) return {};
                return unknown_name("no such choice", value, names).what();
            },
            fmt::format("{{{}}}", fmt::join(names, ","))};
}

void add_exr_option(CLI::App& app, std::filesystem::path& path) {
    app.add_option("--out", path, "EXR file to write")
        ->required()
        ->check([](const std::string& text) -> std::string {
            if (lower_case(std::filesystem::path(text).extension().string()) == ".exr") return {};
            return text + ": what is written is an EXR (valid: a name that ends in .exr)";
        });
}

void add_radii_option(CLI::App& app, std::vector<double>& radii) {
    app.add_option_function<std::vector<std::string>>(
           "--radius",
           [&radii](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) radii.push_back(parse_radius(text));
           },
           "Radii of the truth in metres, \"inf\" for none [the view's own]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("R[,R...]");
}

void add_truth_options(CLI::App& app, TruthEffort& effort) {
    app.add_option("--samples", effort.samples, "Truth rays a pixel; with --error the fewest")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_option("--error", effort.max_error,
                   "Trace until every pixel's standard error is at most this, such as 0.01")
        ->check(CLI::Range(1e-4, 0.5));
}

void add_cache_option(CLI::App& app, std::filesystem::path& folder) {
    folder = default_cache_dir();
    app.add_flag_callback(
        "--no-cache", [&folder] { folder.clear(); },
        "Trace and measure everything anew, and keep nothing of it (see the subcommand cache)");
}

void add_extras_options(CLI::App& app, TruthExtras& extras) {
    app.add_flag("--causes", extras.causes,
                 "Also the occlusion of the first radius by cause: cause.outside.Y, cause.hidden.Y, "
                 "cause.grazing.Y, cause.visible.Y; they add up to it");
    app.add_flag(
        "--one-layer-bound", extras.one_layer_bound,
        "Also one_layer.Y: the occlusion that a method could find at most which knows one depth layer");
    app.add_flag("--bent-normals", extras.bent_normals,
                 "Also bent.X/Y/Z, the mean open direction in view space, and cone.Y, its cone's half angle "
                 "in radians");
}

void add_scene_options(CLI::App& app, SceneChoice& choice) {
    app.add_option("scene", choice.scene, "A built-in scene (see list scenes), or a .gltf or .glb file")
        ->required();
    app.add_option("--view", choice.view, "One of the scene's views (see list views SCENE)");
}

Scene load_with_warnings(const std::string& name_or_path, const LoadOptions& options) {
    Scene scene = load_scene(name_or_path, options);
    for (const std::string& warning : scene.warnings) log_warning(scene.id + ": " + warning);
    return scene;
}

const View& one_view(const Scene& scene, const std::string& view_id) {
    if (!view_id.empty()) return find_view(scene, view_id);
    const View& first = scene.views.front();
    if (scene.views.size() > 1) {
        log_info(fmt::format("{} has {} views; taking {} (choose with --view)", scene.id, scene.views.size(),
                             first.id));
    }
    return first;
}

}  // namespace aoscore
