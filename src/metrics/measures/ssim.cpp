#include "metrics/intervals/block_errors.h"
#include "metrics/measures.h"
#include "metrics/measures/finest_similarity.h"
#include "metrics/measures/mean_error.h"

#include <fmt/format.h>

namespace aoscore {

MetricValue measure::ssim(const MetricInput& input) {
    if (!has_valid_pixel(input)) return undefined(kNoValidPixel);
    const SsimSums sums = finest_similarity(input).by_block;
    const std::optional<SsimMeans> means = sums.means();
    if (!means) return undefined(fmt::format("no valid pixel {} px inside the border", kSsimBorder_px));
    if (input.maps != nullptr) {
        input.maps->ssim_sums = sums.ssim;
        input.maps->ssim_weights = sums.weights;
    }
    if (input.halves != nullptr && input.halves->noisy_maps != nullptr) {
        input.halves->noisy_maps->ssim_sums = sums.noisy_ssim;
        input.halves->noisy_maps->ssim_weights = sums.weights;
    }
    return defined(means->ssim);
}

}  // namespace aoscore
