#include "page/sections/truth_noise_text.h"

#include "metrics/intervals/mask_areas.h"
#include "metrics/roles.h"
#include "page/document/number_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

// A bound is never rounded to nothing.
std::string bound_text(double half_width) {
    return fixed_text(std::max(half_width, 0.0001), 4);
}

}  // namespace

std::string truth_noise_text(const Results& results, const ViewRecord& view) {
    if (!view.halves) return "";
    double ranking = 0, others = 0;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key != view.key || !cell.analysis) continue;
        for (const auto& [metric, half_width] : cell.analysis->truth_noise) {
            if (is_mean_of_mask(metric)) continue;
            double& largest = metric == kRankingMetric ? ranking : others;
            largest = std::max(largest, half_width);
        }
    }
    return fmt::format(
        "The truth of {} has {} rays a pixel in two independent halves: with 95 % confidence its noise moves "
        "debiased RMSEs by {} at most, and the other numbers whose noise is known, areas of missing and "
        "false "
        "occlusion among them, by {} at most.",
        view.key, view.samples, bound_text(ranking), bound_text(others));
}

std::string first_answer_text(const Results& results) {
    if (std::ranges::all_of(results.views, &ViewRecord::final_answer)) return "";
    return "This page is the first answer of a run that goes on. The debiased RMSE and the order of the "
           "ranking are known within their intervals. All other numbers become more exact with more rays. "
           "Those that few rays do not tell, such as SSIM, methods' errors against their own truths, and "
           "costs are not measured yet; the run then writes this page again.";
}

}  // namespace aoscore
