#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/files.h"
#include "experiment/plan.h"
#include "metrics/metric.h"
#include "scene/scene.h"
#include "screen/method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <set>

namespace aoscore {
namespace {

struct Options {
    std::string what;
    std::string scene;
    std::filesystem::path methods_dir;
};

void list_scenes() {
    std::set<std::string> builtin;
    for (const BuiltinScene& scene : builtin_scenes()) {
        builtin.emplace(scene.id);
        fmt::print("{:<20} built in: {}\n", scene.id, scene.description);
    }
    std::set<std::string> known;
    for (const auto& entry : std::filesystem::directory_iterator(home_dir() / "scenes")) {
        const std::string id = entry.path().filename().string();
        if (std::filesystem::exists(entry.path() / "views.json") && !builtin.contains(id)) known.insert(id);
    }
    for (const std::string& id : known) {
        fmt::print("{:<20} views for your own {}.glb (see scenes/README.md)\n", id, id);
    }
}

void list_views(const std::string& scene_name) {
    std::vector<std::string> scenes;
    if (!scene_name.empty()) {
        scenes.push_back(scene_name);
    } else {
        for (const BuiltinScene& scene : builtin_scenes()) scenes.emplace_back(scene.id);
    }
    for (const std::string& name : scenes) {
        const Scene scene = load_with_warnings(name);
        for (const View& view : scene.views) {
            const std::string radius = view.radius_m ? fmt::format(", ranked at {:g} m", *view.radius_m) : "";
            fmt::print("{:<24} {}{}{}\n", scene.id + "/" + view.id, view.source, radius,
                       view.note.empty() ? "" : ", " + view.note);
        }
    }
}

void list_methods(const std::filesystem::path& methods_dir) {
    const auto print = [](const MethodDescriptor& m, const char* kind) {
        std::set<std::string> inputs;
        for (const Pass& pass : m.passes) inputs.insert(pass.inputs.begin(), pass.inputs.end());
        std::vector<std::string> parameters;
        for (const Parameter& p : m.parameters)
            parameters.push_back(fmt::format("{}={}", p.id, p.default_value.dump()));
        std::vector<std::string> presets;
        for (const auto& [id, values] : m.presets) presets.push_back(id);
        fmt::print("{:<20} {}{}. {}; inputs {}; parameters {}; presets {}\n", m.id, kind, m.paper, m.summary,
                   fmt::join(inputs, ", "), fmt::join(parameters, ", "), fmt::join(presets, ", "));
    };
    for (const MethodDescriptor& method : load_methods(methods_dir)) {
        print(method, method.role == MethodRole::bound ? "bound: " : "");
    }
    for (const MethodDescriptor& filter : load_filters()) print(filter, "filter: ");
}

void list_metrics() {
    for (const Metric& metric : metrics()) {
        fmt::print("{:<16} {}: {}{}\n", metric.id, metric.label, metric.meaning,
                   metric.paper.empty() ? "" : fmt::format(" ({})", metric.paper));
    }
}

void list_report_definitions() {
    for (const ReportDefinition& report : list_reports()) {
        fmt::print("{:<20} {} ({})\n", report.id, report.title, report.source);
    }
}

ExitCode run(const Options& options) {
    const std::map<std::string, std::function<void()>> lists{
        {"scenes", list_scenes},
        {"views", [&] { list_views(options.scene); }},
        {"methods", [&] { list_methods(options.methods_dir); }},
        {"metrics", list_metrics},
        {"reports", list_report_definitions},
    };
    lists.at(options.what)();
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_list_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("list", "List what there is");
    const auto options = std::make_shared<Options>();
    app->add_option("what", options->what, "scenes, views, methods, metrics or reports")
        ->required()
        ->check(CLI::IsMember({"scenes", "views", "methods", "metrics", "reports"}));
    app->add_option("scene", options->scene, "For views: one scene [every built-in]");
    app->add_option("--methods-dir", options->methods_dir, "A folder of methods of your own");
    return {app, [options] { return run(*options); }};
}

}  // namespace aoscore
