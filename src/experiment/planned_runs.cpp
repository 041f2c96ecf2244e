#include "experiment/planned_runs.h"

#include "core/log.h"
#include "experiment/score_goal.h"
#include "jobs/recorded/recorded_view.h"
#include "plan/live_output.h"
#include "plan/scene_views.h"
#include "scene/view_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace aoscore {
namespace {

/// The radius that lengths follow; empty where the plan keeps the descriptors' lengths.
std::optional<double> drawn_for(const ViewPlan& plan, const RankingRadius& radius) {
    return plan.own_parameters ? std::nullopt : std::optional(radius.metres);
}

/// The scenes of a plan, each read once.
class PlannedScenes {
  public:
    std::shared_ptr<const Scene> of(const ViewPlan& plan) {
        if (plan.recorded != nullptr) return warned(plan.recorded->scene);
        for (const auto& [reader, scene] : scenes_) {
            if (reader->scene == plan.scene && reader->load == plan.load) return scene;
        }
        auto scene = warned(std::make_shared<const Scene>(load_scene(plan.scene, plan.load)));
        if (plan.view.empty()) {
            if (const std::string left_out = left_out_text(*scene); !left_out.empty()) log_info(left_out);
        }
        scenes_.emplace_back(&plan, scene);
        return scene;
    }

  private:
    static std::shared_ptr<const Scene> warned(std::shared_ptr<const Scene> scene) {
        for (const std::string& warning : scene->warnings) log_warning(scene->id + ": " + warning);
        return scene;
    }

    std::vector<std::pair<const ViewPlan*, std::shared_ptr<const Scene>>> scenes_;
};

// Looks up and loads everything before any work is done or file is written, so that a wrong name costs
// nothing.
std::vector<PreparedView> prepare(const ExperimentPlan& plan, const Registry& registry,
                                  const ArtifactStore& store) {
    for (const ViewPlan& view : plan.views) {
        for (const CellPlan& cell : view.cells) resolve(cell, registry, plan.seed, std::nullopt);
    }
    PlannedScenes scenes;
    std::vector<PreparedView> prepared;
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const ViewPlan& wanted = plan.views[i];
        const std::shared_ptr<const Scene> scene = scenes.of(wanted);
        const double aspect = static_cast<double>(wanted.width) / wanted.height;
        RankingRadii radii(*scene);
        std::vector<View> views = wanted_views(*scene, wanted.load, wanted.view, aspect, store);
        if (const std::string text = no_camera_text(*scene, views); !text.empty()) log_info(text);
        for (View& view : views) {
            CameraFrame(view.camera, wanted.width, wanted.height);
            PreparedView p{&wanted, i, {}, scene, view, radii.of(wanted.radius_m, view), {}};
            if (p.radius.automatic) log_warning(scene->id + ": " + radius_warning(p.radius, view));
            for (const CellPlan& cell : wanted.cells)
                p.cells.push_back(resolve(cell, registry, plan.seed, drawn_for(*p.plan, p.radius)));
            prepared.push_back(std::move(p));
        }
    }
    // Views of one scene come one after the other, so that it is built once.
    std::vector<const Scene*> order;
    for (const PreparedView& p : prepared) {
        if (std::find(order.begin(), order.end(), p.scene.get()) == order.end())
            order.push_back(p.scene.get());
    }
    std::stable_sort(prepared.begin(), prepared.end(), [&](const PreparedView& a, const PreparedView& b) {
        return std::find(order.begin(), order.end(), a.scene.get()) <
               std::find(order.begin(), order.end(), b.scene.get());
    });
    return prepared;
}

// Names the views in the results. One view in two sizes, or at two radii, gets two entries.
void name_views(std::vector<PreparedView>& prepared) {
    std::set<std::string> taken;
    for (PreparedView& p : prepared) {
        p.key = p.scene->id + "/" + p.view.id;
        if (taken.contains(p.key)) p.key += fmt::format("@{}x{}", p.plan->width, p.plan->height);
        if (taken.contains(p.key)) p.key += fmt::format("@{:g}m", p.radius.metres);
        taken.insert(p.key);
    }
}

/// The queries of methods' own truths that differ from `ranked`, the ranking's.
std::vector<TruthQuery> own_queries(const std::vector<CellWork>& cells, const TruthQuery& ranked) {
    std::vector<TruthQuery> queries;
    for (const CellWork& cell : cells) {
        if (cell.own && *cell.own != ranked && std::ranges::find(queries, *cell.own) == queries.end())
            queries.push_back(*cell.own);
    }
    return queries;
}

TruthSettings truth_settings(const ViewPlan& plan, std::uint64_t seed) {
    TruthSettings settings;
    settings.samples = plan.samples;
    settings.max_error = plan.max_error;
    if (plan.score_goal) {
        settings.samples = ScoreGoal::kFirstSamples;
        settings.max_error = 0;
        settings.halves = true;
    }
    settings.seed = seed;
    settings.extras = plan.extras;
    return settings;
}

bool is_lit(const CellPlan& cell, const ExperimentPlan& plan) {
    return cell.lit_by_environment && !cell.step && !plan.first_answer;
}

/// What the view is lit by; null where none of its cells is lit.
std::shared_ptr<const Environment> environment_of(const PreparedView& view, const ExperimentPlan& plan) {
    static const auto sky = std::make_shared<const Environment>(generated_sky());
    const bool any =
        std::ranges::any_of(view.cells, [&](const ResolvedCell& cell) { return is_lit(cell.plan, plan); });
    if (!any) return nullptr;
    return view.plan->environment != nullptr ? view.plan->environment : sky;
}

CellWork cell_work(const ResolvedCell& cell, const ExperimentPlan& plan, const PreparedView& view,
                   const Registry& registry, std::optional<double> drawn_for_m) {
    CellWork work;
    work.id = fmt::format("{}/{}", view.key, cell_name(cell.plan));
    work.contestant = contestant_on(view.view.id, view.radius.metres, cell, registry);
    work.timed = cell.request;
    if (cell.plan.own_truth && !plan.first_answer) work.own = cell.own;
    work.keep_image = cell.plan.keep_image;
    work.wants_times = cell.plan.timed;
    work.whole_frames = cell.plan.whole_frames;
    work.repeats = cell.plan.repeats && !plan.first_answer;
    work.converged = cell.converged;
    work.lit_by_environment = is_lit(cell.plan, plan);
    if (work.whole_frames) light(work.timed, registry.lighting, drawn_for_m);
    return work;
}

MethodRequest fixed_pass_request(const Registry& registry, bool lit, std::uint64_t seed,
                                 std::optional<double> drawn_for_m) {
    MethodRequest request;
    request.method = &registry.fixed_pass;
    request.parameters = registry.fixed_pass.values("default");
    request.seed = seed;
    if (lit) light(request, registry.lighting, drawn_for_m);
    return request;
}

/// Makes the work of one view, from which its jobs are laid out.
ViewWork view_work(const ExperimentPlan& plan, const PreparedView& p, const Registry& registry,
                   SceneTools& tools, const std::filesystem::path& folder) {
    const std::optional<double> drawn_for_m = drawn_for(*p.plan, p.radius);
    std::vector<CellWork> cells;
    for (const ResolvedCell& cell : p.cells) cells.push_back(cell_work(cell, plan, p, registry, drawn_for_m));
    const TruthQuery ranked{Falloff::binary, p.radius.metres, 0};
    const TruthSettings truth = truth_settings(*p.plan, plan.seed);
    TruthSettings own_truth = truth;
    own_truth.extras = {};
    return {.scene = *p.scene,
            .view = p.view,
            .tools = tools,
            .gl_renderer = tools.renderer().renderer(),
            .gl_version = tools.renderer().version(),
            .width = p.plan->width,
            .height = p.plan->height,
            .key = p.key,
            .radius_m = p.radius.metres,
            .queries = {ranked},
            .truth = truth,
            .own_queries = own_queries(cells, ranked),
            .own_truth = own_truth,
            .cells = std::move(cells),
            .fixed_pass = fixed_pass_request(registry, p.plan->lit, plan.seed, drawn_for_m),
            .timing_goal = p.plan->timing_goal,
            .timed = !plan.first_answer,
            .untold = !plan.first_answer,
            .seed = plan.seed,
            .environment = environment_of(p, plan),
            .keep_gbuffer = plan.keep_gbuffer,
            .kept_inputs = gbuffer_inputs_of(registry),
            .truth_cache = plan.truth_cache,
            .recorded = p.plan->recorded,
            .command = plan.command,
            .folder = folder};
}

ViewRun view_run(const ExperimentPlan& plan, const PreparedView& p, const Registry& registry,
                 SceneTools& tools, const std::filesystem::path& folder) {
    ViewRun run{.plan = *p.plan,
                .radius = p.radius,
                .drawn_for_m = drawn_for(*p.plan, p.radius),
                .cells = p.cells,
                .work = view_work(plan, p, registry, tools, folder),
                .jobs = {}};
    if (p.plan->lit) {
        run.lighting = registry.lighting.label;
        run.lighting_parameters = drawn_values(registry.lighting, "default", {}, run.drawn_for_m);
    }
    run.jobs = view_jobs(run.work);
    return run;
}

}  // namespace

PlannedRuns::PlannedRuns(const ExperimentPlan& plan, const ArtifactStore& store)
    : plan_(plan), store_(store) {
    std::vector<std::string> left_out;  // unused: the plan names none of them
    registry_ = load_registry(plan.methods_dir, {}, left_out);
    for (const auto& file : plan.preset_files) add_presets(registry_.methods, file);
    registry_.outside = plan.outside;
    prepared_ = prepare(plan, registry_, store);
    name_views(prepared_);
}

void PlannedRuns::lay_out(const std::filesystem::path& folder) {
    for (const PreparedView& p : prepared_)
        runs_.push_back(with_known_rays(view_run(plan_, p, registry_, tools_, folder), store_));
}

}  // namespace aoscore
