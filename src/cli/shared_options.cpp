#include "cli/shared_options.h"

#include "cli/number_range.h"
#include "core/error.h"
#include "core/known_names.h"
#include "core/text.h"
#include "jobs/truth_channels.h"
#include "plan/scene_views.h"
#include "reference/sampling/sample_plan.h"
#include "scene/scene_frame.h"
#include "scene/view_choice.h"
#include "scene/view_limits.h"
#include "store/truth/truth_cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

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

constexpr double kGivenFovy_deg = 60;

glm::dvec3 parse_point(const char* option, const std::string& text) {
    glm::dvec3 point;
    const char *at = text.data(), *const end = text.data() + text.size();
    for (int axis = 0; axis < 3; ++axis) {
        const auto [next, ec] = std::from_chars(at, end, point[axis]);
        const bool is_last = axis == 2;
        if (ec != std::errc() || !is_float32(point[axis]) ||
            (is_last ? next != end : next == end || *next != ','))
            throw CLI::ValidationError(option,
                                       "\"" + text + "\" is no point such as 1.5,2,-3 of float32 numbers");
        at = next + 1;
    }
    return point;
}

/// Sets `up`: a camera that looks straight up or down has the top of its picture at -z.
void face_target(Camera& camera) {
    const glm::dvec3 sight = camera.target - camera.position;
    if (sight == glm::dvec3(0)) throw CLI::ValidationError("--target", "is where --eye is");
    if (glm::length(glm::cross(glm::normalize(sight), camera.up)) < 1e-6) camera.up = {0, 0, -1};
}

}  // namespace

void add_size_option(CLI::App& app, ImageSize& size) {
    app.add_option_function<std::string>(
           "--size", [&size](const std::string& text) { size = parse_image_size(text, "--size"); },
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

int TruthEffort::least_samples() const {
    constexpr int kUsual = 64;
    return samples.value_or(max_error > 0 || mean_error > 0 ? kFewestToTellError : kUsual);
}

CLI::Validator error_of_truth() {
    return number_in(kLeastError, 0.5, "float32 numbers, which truths are, round by as much");
}

void add_truth_options(CLI::App& app, TruthEffort& effort) {
    app.add_option("--samples", effort.samples,
                   fmt::format("Truth rays a pixel, 64 unless an error is asked for; with one the fewest, {} "
                               "unless named",
                               kFewestToTellError))
        ->check(CLI::Range(1, kMostSamples));
    app.add_option("--error", effort.max_error,
                   "Trace until every pixel's standard error is at most this, such as 0.01")
        ->check(error_of_truth());
}

CLI::Option* add_score_error_option(CLI::App& app, std::optional<double>& error) {
    return app
        .add_option(
            "--score-error", error,
            fmt::format("Trace until the truth's noise leaves every debiased RMSE within this, 95 % of the "
                        "time, and every other metric and the areas of missing and false occlusion within "
                        "{:g} times this; the page is written as soon as "
                        "noise cannot change the ranking, and again at the end [{:g}]",
                        ScoreGoal::kOtherMetrics, ScoreGoal().error))
        ->check(error_of_truth());
}

void add_score_truth_options(CLI::App& app, TruthEffort& effort) {
    add_truth_options(app, effort);
    add_score_error_option(app, effort.score_error)->excludes("--samples")->excludes("--error");
}

std::optional<ScoreGoal> score_goal(const TruthEffort& effort) {
    if (effort.samples || effort.max_error > 0) return std::nullopt;
    ScoreGoal goal;
    goal.error = effort.score_error.value_or(goal.error);
    return goal;
}

void add_cache_option(CLI::App& app, std::filesystem::path& folder) {
    folder = cache_dir();
    app.add_flag_callback(
        "--no-cache", [&folder] { folder.clear(); },
        "Trace and measure everything anew, and keep nothing of it (see the subcommand cache)");
}

std::optional<double> one_finite_radius(const std::vector<double>& radii, const std::string& work) {
    if (radii.empty()) return std::nullopt;
    if (radii.size() > 1 || !std::isfinite(radii[0]))
        throw usage_error(work + " at one finite radius", "--radius", "one length in metres");
    return radii[0];
}

CLI::Validator even_count() {
    return CLI::Range(2, kMostSamples) &
           CLI::Validator(
               [](const std::string& text) { return std::stoll(text) % 2 == 0 ? "" : text + " is odd"; }, "",
               "even");
}

void add_extras_options(CLI::App& app, TruthExtras& extras) {
    const auto add = [&](const char* option, bool TruthExtras::*extra) {
        app.add_flag(option, extras.*extra, "Also, at the first radius: " + channels_gathered_by(extra));
    };
    add("--causes", &TruthExtras::causes);
    add("--one-layer-bound", &TruthExtras::one_layer_bound);
    add("--bent-normals", &TruthExtras::bent_normals);
}

void add_frame_options(CLI::App& app, LoadOptions& load) {
    app.add_option_function<std::string>(
           "--unit",
           [&load](const std::string& text) {
               load.metres_per_unit = parse_unit(text);
               if (!load.metres_per_unit)
                   throw CLI::ValidationError("--unit",
                                              "\"" + text + "\" is no unit and no number of metres above 0");
           },
           "What a unit of the scene's file is: m, cm, mm, in, ft, km, or metres as a number [what the file "
           "states; "
           "where it states none, what its view file recognises, else m]")
        ->type_name("UNIT");
    app.add_option_function<std::string>(
           "--up", [&load](const std::string& text) { load.up = text == "z" ? UpAxis::z : UpAxis::y; },
           "Which axis of the scene's file is up [what the file states, else y]")
        ->check(CLI::IsMember({"y", "z"}));
}

void add_view_options(CLI::App& app, ViewChoice& choice) {
    add_frame_options(app, choice.load);
    CLI::Option* view =
        app.add_option(
               "--view", choice.views,
               "Views of the scene (see list views SCENE); file, nodes or auto: those of its view file, "
               "of its own cameras, automatic ones; all [those of the first of these that it has]")
            ->delimiter(',')
            ->allow_extra_args(false);
    CLI::Option* file = app.add_option("--views", choice.load.view_file,
                                       "A view file [NAME.views.json beside the scene NAME, or the one that "
                                       "scenes/ has for it]")
                            ->check(CLI::ExistingFile);
    const auto camera = [&choice]() -> Camera& {
        if (!choice.load.camera) choice.load.camera.emplace().fovy_rad = glm::radians(kGivenFovy_deg);
        return *choice.load.camera;
    };
    CLI::Option* eye = app.add_option_function<std::string>(
        "--eye", [camera](const std::string& text) { camera().position = parse_point("--eye", text); },
        "A camera of your own stands there, in metres with +y up: the file's coordinates after --unit and "
        "--up");
    CLI::Option* target = app.add_option_function<std::string>(
        "--target", [camera](const std::string& text) { camera().target = parse_point("--target", text); },
        "What it looks at, likewise");
    CLI::Option* fovy = app.add_option_function<double>(
        "--fovy", [camera](double degrees) { camera().fovy_rad = glm::radians(degrees); },
        fmt::format("Its vertical angle of view in degrees [{:g}]", kGivenFovy_deg));
    eye->type_name("X,Y,Z")->needs(target)->excludes(view)->excludes(file);
    target->type_name("X,Y,Z")->needs(eye);
    fovy->type_name("DEG")->check(number_in(0.1, 179.0))->needs(eye);
    app.final_callback([&choice] {
        if (choice.load.camera) face_target(*choice.load.camera);
    });
}

std::vector<std::string> planned_views(const ViewChoice& choice) {
    return choice.views.empty() ? std::vector<std::string>{""} : choice.views;
}

void add_scene_options(CLI::App& app, SceneChoice& choice) {
    app.add_option("scene", choice.scene,
                   "A built-in scene (see list scenes), or a .gltf, .glb, .obj, .fbx, .ply or .stl file")
        ->required();
    add_view_options(app, choice.view);
}

Scene load_with_warnings(const std::string& name_or_path, const LoadOptions& options) {
    Scene scene = load_scene(name_or_path, options);
    for (const std::string& warning : scene.warnings) log_warning(scene.id + ": " + warning);
    return scene;
}

View one_view(const Scene& scene, const ViewChoice& choice, const ImageSize& size,
              const std::filesystem::path& cache) {
    if (choice.views.size() > 1) throw usage_error("several views", "--view", "one");
    const std::vector<View> views = wanted_views(scene, choice.load, planned_views(choice).front(),
                                                 static_cast<double>(size.width) / size.height,
                                                 ArtifactStore(ArtifactStore::folder_in(cache)));
    if (const std::string text = no_camera_text(scene, views); !text.empty()) log_info(text);
    if (views.size() > 1) {
        log_info(fmt::format("{} has {} such views; taking {} (choose with --view)", scene.id, views.size(),
                             views.front().id));
    }
    return views.front();
}

}  // namespace aoscore
