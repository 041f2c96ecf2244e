#include "metrics/mean_error.h"
#include "metrics/measures.h"
#include "metrics/structural_similarity.h"

#include <fmt/format.h>

namespace aoscore {

MetricValue measure::ssim(const MetricInput& input) {
    if (!has_valid_pixel(input)) return undefined(kNoValidPixel);
    const std::optional<SsimMeans> means =
        structural_similarity(input.truth, input.test, weights_of(input.valid));
    if (!means) return undefined(fmt::format("no valid pixel {} px inside the border", kSsimBorder_px));
    return defined(means->ssim);
}

}  // namespace aoscore
