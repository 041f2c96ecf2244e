#include "metrics/mean_error.h"
#include "metrics/measures.h"
#include "metrics/structural_similarity.h"

#include <fmt/format.h>

namespace aoscore {

MetricValue measure::ssim(const MetricInput& input) {
    if (!mean_squared_error(input)) return undefined(kNoValidPixel);
    const std::optional<SsimMeans> means = structural_similarity(weighted_pair(input));
    if (!means) return undefined(fmt::format("no valid pixel {} px inside the border", kSsimBorder_px));
    return defined(means->ssim);
}

}  // namespace aoscore
