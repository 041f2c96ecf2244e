#include "metrics/intervals/mask_areas.h"

#include "metrics/analysis/analysis.h"
#include "metrics/intervals/drawn_sums.h"

#include <algorithm>

namespace aoscore {
namespace {

/// The share of the pixels, which noise taken off may have brought below nothing.
double area_of(double sum, double count) {
    return sum < 0 ? 0.0 : sum / count;  // not std::max, which would turn NaN into 0
}

}  // namespace

const std::array<MaskArea, 2>& mask_areas() {
    static constexpr std::array<MaskArea, 2> table{{
        {kMissingArea, "missing_mean", "Missing", "brighter",
         [](const ErrorAnalysis& a) { return a.missing.area; },
         [](const ErrorAnalysis& a) { return a.missing.mean; },
         [](const DrawnSums& s) { return area_of(s.missing, s.count); }},
        {kFalseArea, "false_mean", "False", "darker",
         [](const ErrorAnalysis& a) { return a.false_occlusion.area; },
         [](const ErrorAnalysis& a) { return a.false_occlusion.mean; },
         [](const DrawnSums& s) { return area_of(s.false_occlusion, s.count); }},
    }};
    return table;
}

bool is_mean_of_mask(std::string_view id) {
    return std::ranges::find(mask_areas(), id, &MaskArea::mean_id) != mask_areas().end();
}

}  // namespace aoscore
