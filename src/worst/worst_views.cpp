#include "worst/worst_views.h"

#include "core/error.h"
#include "core/log.h"
#include "core/progress.h"
#include "framing/automatic_views.h"
#include "framing/spread_cameras.h"
#include "metrics/roles.h"
#include "tuning/objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr int kCoarseHeight_px = 90, kCoarseSamples = 16;
/// So many times the views wanted are confirmed: their order may change.
constexpr std::size_t kConfirmed = 2;

/// Judges views by a method's error, or by how much larger it is than the rival's.
class Judge {
  public:
    Judge(const WorstPlan& plan, const Scene& scene, double radius_m)
        : plan_(plan), scene_(scene), radius_m_(radius_m), registry_(registry_of(plan)) {
        tools_.choose(scene);
        subjects_.push_back({plan.method, {}, kRankingMetric, plan.seed});
        if (plan.rival) subjects_.push_back({*plan.rival, {}, kRankingMetric, plan.seed});
        for (const TuningSubject& subject : subjects_) {
            const ResolvedCell cell = resolve(subject.cell, registry_, plan.seed, radius_m);
            inputs_.merge(needed_gbuffer_inputs(cell.request));
        }
    }

    double verdict(const View& view, int width, int height, int samples) {
        std::vector<std::unique_ptr<TuningView>> views;
        views.push_back(ready_view({&scene_, view, width, height, samples, radius_m_}, tools_.reference(),
                                   tools_.ready_renderer(), inputs_, plan_.truth_cache, plan_.command));
        const ArtifactStore store(ArtifactStore::folder_in(plan_.truth_cache));
        double result = 0, sign = 1;
        for (const TuningSubject& subject : subjects_) {
            result += sign * Objective(subject, registry_, views, tools_.renderer(), store).loss({}, 0);
            sign = -1;
        }
        return result;
    }

  private:
    static Registry registry_of(const WorstPlan& plan) {
        std::vector<std::string> warnings;
        return load_registry(plan.methods_dir, {}, warnings);
    }

    const WorstPlan& plan_;
    const Scene& scene_;
    double radius_m_;
    Registry registry_;
    SceneTools tools_;
    std::vector<TuningSubject> subjects_;
    std::set<std::string> inputs_;
};

/// Judges all cameras by small pictures. One on which nothing can be compared is left out.
std::vector<FoundView> judged_coarsely(const SpreadCameras& spread, const WorstPlan& plan, Judge& judge) {
    const int width = kCoarseHeight_px * plan.width / plan.height;
    std::vector<FoundView> judged;
    Progress progress("cameras", spread.cameras.size());
    for (std::size_t i = 0; i < spread.cameras.size(); ++i) {
        FoundView found{automatic_view_of(fmt::format("camera_{}", i + 1), spread.cameras[i].camera)};
        try {
            found.coarse = judge.verdict(found.view, width, kCoarseHeight_px, kCoarseSamples);
            judged.push_back(std::move(found));
        } catch (const Error& e) {
            if (e.exit_code() != ExitCode::gate_failed && e.exit_code() != ExitCode::internal) throw;
            log_info(fmt::format("{} is left out: {}", found.view.id, e.what()));
        }
        progress.step();
    }
    return judged;
}

/// The first views of the list that are no neighbours of each other.
std::vector<FoundView> distinct(const std::vector<FoundView>& sorted, double apart_m, std::size_t most) {
    std::vector<FoundView> chosen;
    for (const FoundView& found : sorted) {
        if (chosen.size() == most) break;
        const bool apart = std::ranges::none_of(chosen, [&](const FoundView& other) {
            return are_neighbours(found.view.camera, other.view.camera, apart_m);
        });
        if (apart) chosen.push_back(found);
    }
    return chosen;
}

}  // namespace

WorstViews find_worst_views(const WorstPlan& plan, const Scene& scene) {
    WorstViews result;
    result.radius_m = search_radius_m(plan.radius_m, scene);
    const Scout scout(scene);
    const MainPart main = main_part(scene);
    const Trial trial{scout, main, result.radius_m, static_cast<double>(plan.width) / plan.height,
                      scene.bounds};
    const SpreadCameras spread = spread_cameras(trial, plan.cameras, plan.height_m);
    Judge judge(plan, scene, result.radius_m);
    std::vector<FoundView> judged = judged_coarsely(spread, plan, judge);
    if (judged.empty()) throw no_camera_to_judge(spread, scene.id);
    std::ranges::sort(judged, std::ranges::greater(), &FoundView::coarse);
    result.tried = spread.tried;
    result.judged = judged.size();
    result.inside = spread.inside;
    result.median = judged[judged.size() / 2].coarse;
    if (plan.rival)
        result.rival_won = static_cast<std::size_t>(
            std::ranges::count_if(judged, [](const FoundView& f) { return f.coarse > 0; }));
    result.views = distinct(judged, spread.apart_m, kConfirmed * plan.views);
    for (FoundView& found : result.views)
        found.confirmed = judge.verdict(found.view, plan.width, plan.height, plan.samples);
    std::ranges::sort(result.views, std::ranges::greater(), &FoundView::confirmed);
    if (result.views.size() > plan.views) result.views.resize(plan.views);
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        result.views[i].view.id = fmt::format("worst_{}", i + 1);
        result.views[i].view.radius_m = result.radius_m;
    }
    return result;
}

}  // namespace aoscore
