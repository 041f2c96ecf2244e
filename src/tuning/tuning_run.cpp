#include "tuning/tuning_run.h"

#include "core/error.h"
#include "core/log.h"
#include "metrics/evaluate.h"
#include "plan/run_modes.h"
#include "plan/scene_views.h"
#include "screen/method/depth_layers.h"
#include "store/artifact_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <utility>

namespace aoscore {
namespace {

/// The inputs that any of the methods reads.
std::set<std::string> inputs_of(const std::vector<TuningPlan::Method>& methods, const Registry& registry,
                                std::uint64_t seed) {
    std::set<std::string> inputs;
    for (const auto& [cell, parameters, effort] : methods) {
        const ResolvedCell resolved = resolve(cell, registry, seed, std::nullopt);
        if (reads_ray_layers(*resolved.request.method, resolved.request.parameters)) {
            throw usage_error(cell.method + " reads layers that rays meet, and a search keeps no ray tracer",
                              "tune --methods", "another sampling of layers");
        }
        inputs.merge(needed_gbuffer_inputs(resolved.request));
    }
    return inputs;
}

/// All views, ready for every method.
class ReadyViews {
  public:
    ReadyViews(const TuningPlan& plan, const std::set<std::string>& inputs, const ArtifactStore& store) {
        for (const TuningPlan::OnScene& on : plan.scenes) {
            scenes_.push_back(load_scene(on.scene, on.load));
            const Scene& scene = scenes_.back();
            for (const std::string& warning : scene.warnings) log_warning(warning);
            tools_.choose(scene);
            const double aspect = static_cast<double>(plan.width) / plan.height;
            for (const std::string& choice : on.views) {
                for (const View& view : wanted_views(scene, on.load, choice, aspect, store)) {
                    views_.push_back(ready_view(
                        {&scene, view, plan.width, plan.height, plan.samples, plan.radius_m},
                        tools_.reference(), tools_.ready_renderer(), inputs, plan.truth_cache, plan.command));
                }
            }
        }
    }

    const std::vector<std::unique_ptr<TuningView>>& views() const { return views_; }
    ScreenRenderer& renderer() { return tools_.renderer(); }

  private:
    std::list<Scene> scenes_;  // a list: its elements stay where they are
    SceneTools tools_;
    std::vector<std::unique_ptr<TuningView>> views_;
};

void require_several(const TuningPlan& plan, std::size_t views) {
    if (views > 1 || plan.in_sample) return;
    throw usage_error("one view is left: nothing could be left out to see how the settings do elsewhere",
                      "tune", "several views or scenes, or --in-sample");
}

/// Refuses lengths in metres, which a preset that is found could not hold, since a preset's follow the
/// radius; says what else it cannot hold: parameters of filters, and modes.
void require_preset_holds(const CellPlan& cell, const MethodDescriptor& method) {
    for (const auto& [id, value] : cell.overrides) {
        const Parameter* p = method.find_parameter(id);
        if (p != nullptr && p->length_power != 0)
            throw usage_error(
                id + " is a length, and keeps its metres where it is set: a preset's follow the radius",
                method.id + " --set", "parameters without a unit");
    }
    if (!cell.filter_overrides.empty())
        log_warning(method.id +
                    ": the preset cannot hold parameters of its filter; set them where it is used");
    for (const auto& [mode, choice] : unusual_modes(cell.modes))
        log_warning(fmt::format("{}: the preset cannot hold --{} {}; give it where it is used", method.id,
                                mode, choice));
}

/// The parameters to tune, without those that were set.
std::vector<SearchAxis> free_axes(const CellPlan& cell, const MethodDescriptor& method,
                                  const std::vector<std::string>& wanted, bool counts) {
    std::vector<SearchAxis> axes = search_axes(method, cell.preset, wanted, counts);
    const auto is_set = [&](const SearchAxis& axis) { return cell.overrides.contains(axis.parameter); };
    const auto set = std::ranges::find_if(axes, is_set);
    if (set != axes.end() && !wanted.empty())
        throw usage_error(set->parameter + " is both set and to be tuned", method.id,
                          "one of --set, --parameters");
    std::erase_if(axes, is_set);
    if (axes.empty()) throw usage_error("all that could be tuned is set", method.id + " --set");
    return axes;
}

std::vector<TuningSubject> subjects_of(const TuningPlan& plan, const Registry& registry) {
    const bool limited = std::ranges::any_of(plan.budgets, &Budget::is_limited);
    std::vector<TuningSubject> subjects;
    for (const auto& [cell, parameters, effort] : plan.methods) {
        const MethodDescriptor& method = find_method(registry.methods, cell.method);
        require_preset_holds(cell, method);
        subjects.push_back({cell, free_axes(cell, method, parameters, limited), plan.metric, plan.seed});
    }
    return subjects;
}

}  // namespace

TuningResults tune(const TuningPlan& plan) {
    require_best_value(metric(plan.metric));
    std::vector<std::string> warnings;
    std::vector<std::string> asked;
    for (const TuningPlan::Method& method : plan.methods) asked.push_back(method.cell.method);
    const Registry registry = load_registry(plan.methods_dir, asked, warnings);
    for (const std::string& warning : warnings) log_warning(warning);
    const std::vector<TuningSubject> subjects = subjects_of(plan, registry);
    const ArtifactStore store(ArtifactStore::folder_in(plan.truth_cache));
    ReadyViews ready(plan, inputs_of(plan.methods, registry, plan.seed), store);
    require_several(plan, ready.views().size());

    TuningResults results;
    for (const auto& view : ready.views()) {
        results.views.push_back(view->key);
        results.radii_m.push_back(view->radius.metres);
    }
    for (std::size_t m = 0; m < subjects.size(); ++m) {
        const TuningSubject& subject = subjects[m];
        log_info(fmt::format("tuning {} ({} parameters) on {} views", subject.cell.method,
                             subject.axes.size(), ready.views().size()));
        Objective objective(subject, registry, ready.views(), ready.renderer(), store);
        MethodTuning& tuning = results.methods.emplace_back();
        tuning.cell = subject.cell;
        tuning.label = find_method(registry.methods, subject.cell.method).shown_label();
        tuning.axes = subject.axes;
        const SearchEffort effort = plan.methods[m].effort.value_or(plan.effort);
        for (const Budget& budget : plan.budgets)
            tuning.budgets.push_back(tuned(subject, objective, ready.views(), budget, effort));
        tuning.drawn = objective.drawn();
        tuning.reused = objective.reused();
    }
    return results;
}

}  // namespace aoscore
