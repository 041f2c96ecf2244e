#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/folders.h"
#include "core/output.h"
#include "jobs/contest/outside_method.h"
#include "metrics/metric.h"
#include "metrics/signal_metric.h"
#include "plan/plan.h"
#include "plan/scene_views.h"
#include "plan/view_description.h"
#include "results/light_modes.h"
#include "scene/scene.h"
#include "scene/view_file.h"
#include "screen/gl/context.h"
#include "screen/gl/egl_context.h"
#include "screen/method/lengths.h"
#include "screen/method/method.h"
#include "screen/screen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <set>

namespace aoscore {
namespace {

struct ListOptions {
    std::string what;
    std::string scene;
    ViewChoice view;
    std::filesystem::path methods_dir;
};

void list_scenes() {
    std::set<std::string> builtin;
    for (const BuiltinScene& scene : builtin_scenes()) {
        builtin.emplace(scene.id);
        print_result("{:<20} built in: {}\n", scene.id, scene.description);
    }
    for (const std::string& id : scenes_with_view_files()) {
        if (builtin.contains(id)) continue;
        print_result("{:<20} views for your own {} file (see scenes/README.md)\n", id, id);
    }
}

void list_builtin_views() {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = load_with_warnings(std::string(builtin.id));
        for (const View& view : scene.views) {
            const std::string radius = view.radius_m ? fmt::format(", ranked at {:g} m", *view.radius_m) : "";
            print_result("{:<24} {}{}{}\n", scene.id + "/" + view.id, view.source, radius,
                         view.note.empty() ? "" : ", " + view.note);
        }
    }
}

void list_views(const std::string& scene_name, const ViewChoice& choice) {
    if (scene_name.empty()) return list_builtin_views();
    constexpr double kListedAspect = 16.0 / 9;
    const ArtifactStore store(ArtifactStore::folder_in(cache_dir()));
    const Scene scene = load_with_warnings(scene_name, choice.load);
    std::vector<View> views;
    for (const std::string& id : choice.views.empty() ? std::vector<std::string>{"all"} : choice.views) {
        for (View& view : wanted_views(scene, choice.load, id, kListedAspect, store))
            views.push_back(std::move(view));
    }
    for (const View& view : views) {
        log_info(
            fmt::format("{}: from {}{}", view.id, view.source, view.note.empty() ? "" : ", " + view.note));
    }
    print_result("{}\n", view_file_text(scene, views));
}

void list_methods(const std::filesystem::path& methods_dir) {
    const auto print = [](const MethodDescriptor& m, const char* kind) {
        std::set<std::string> inputs;
        for (const Pass& pass : m.passes) inputs.insert(pass.inputs.begin(), pass.inputs.end());
        std::vector<std::string> parameters;
        for (const Parameter& p : m.parameters)
            parameters.push_back(fmt::format("{}={}", p.id, p.default_value.text()));
        std::vector<std::string> presets;
        for (const auto& [id, values] : m.presets)
            presets.push_back(id + (m.absolute_presets.contains(id) ? " (keeps its lengths)" : ""));
        const std::optional<double> radius_m = reference_radius(m, "default");
        const std::string meant =
            radius_m ? fmt::format(", lengths for an AO radius of {:g} m", *radius_m) : "";
        print_result("{:<20} {}{}. {}; inputs {}; parameters {}{}; presets {}\n", m.id, kind, m.paper,
                     m.summary, fmt::join(inputs, ", "), fmt::join(parameters, ", "), meant,
                     fmt::join(presets, ", "));
    };
    std::vector<std::string> warnings;
    for (const MethodDescriptor& method : load_asked_methods(methods_dir, {}, warnings)) {
        print(method, method.role == MethodRole::bound ? "bound: " : "");
    }
    for (const std::string& warning : warnings) log_warning(warning);
    for (const MethodDescriptor& filter : load_filters()) print(filter, "filter: ");
}

void list_metrics() {
    for (const Metric& metric : metrics()) {
        print_result("{:<16} {}: {}{}\n", metric.id, metric.label, metric.meaning,
                     metric.paper.empty() ? "" : fmt::format(" ({})", metric.paper));
    }
    for (const SignalMetric& metric : signal_metrics()) {
        print_result("{:<16} {}: {} (of {}, with --signals)\n", metric.id, metric.label, metric.meaning,
                     metric.signal);
    }
    for (const LightMode& mode : light_modes()) {
        print_result(
            "{}{:<10} Error of light by the {}: {} Over the mean of the traced irradiance (with "
            "--environment)\n",
            kLightPrefix, mode.relative_error(), mode.label, mode.meaning);
    }
}

void list_experiment_definitions() {
    for (const ExperimentDefinition& experiment : list_experiments()) {
        print_result("{:<20} {} ({})\n", experiment.id, experiment.title, experiment.source);
    }
}

void list_contestants() {
    for (const auto& [id, folder] : outside_folders()) {
        const OutsideMethod outside = load_outside_method(folder);
        std::vector<std::string> presets;
        for (const auto& [preset, values] : outside.method.presets) presets.push_back(preset);
        print_result("{:<20} {}; presets {}; {}\n", id, outside.method.label, fmt::join(presets, ", "),
                     outside.command ? "by a command, " + outside.command->version : "images of views");
    }
}

void print_device(const std::string& gl, const std::string& name) {
    try {
        choose_gl(gl);
        const ScreenRenderer renderer;
        print_result("{:<10} {}: {}, OpenGL {}\n", gl, name, renderer.renderer(), renderer.version());
    } catch (const Error& e) {
        print_result("{:<10} {}: {}\n", gl, name, e.what());
    }
}

void list_devices() {
    const std::string chosen = chosen_gl();
    print_device("osmesa", "software, the default");
    try {
        const std::vector<std::string> names = egl_devices();
        for (std::size_t i = 0; i < names.size(); ++i) print_device(fmt::format("egl:{}", i), names[i]);
    } catch (const Error& e) {
        print_result("{:<10} {}\n", "egl", e.what());
    }
    choose_gl(chosen);
}

ExitCode run(const ListOptions& options, const CLI::App& app) {
    if (options.what.empty()) {
        write_output(app.help());
        return ExitCode::ok;
    }
    const std::map<std::string, std::function<void()>> lists{
        {"scenes", list_scenes},
        {"views", [&] { list_views(options.scene, options.view); }},
        {"methods", [&] { list_methods(options.methods_dir); }},
        {"metrics", list_metrics},
        {"experiments", list_experiment_definitions},
        {"contestants", list_contestants},
        {"devices", list_devices},
    };
    lists.at(options.what)();
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_list_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("list", "List what there is");
    const auto options = std::make_shared<ListOptions>();
    app->add_option(
           "what", options->what,
           "scenes, views, methods, metrics, experiments, contestants (of other programs) or devices, which "
           "draw (see --gl)")
        ->check(one_of({"scenes", "views", "methods", "metrics", "experiments", "contestants", "devices"}))
        // The earlier name, which scripts use.
        ->transform([](std::string what) { return what == "reports" ? "experiments" : std::move(what); });
    app->add_option("scene", options->scene,
                    "For views: one scene, whose views are printed as a view file [every built-in]");
    add_view_options(*app, options->view);
    app->add_option("--methods-dir", options->methods_dir, "A folder of methods of your own");
    return {app, [options, app] { return run(*options, *app); }};
}

}  // namespace aoscore
