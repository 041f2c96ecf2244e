#include "metrics/intervals/block_errors.h"
#include "metrics/measures.h"
#include "metrics/measures/finest_similarity.h"
#include "metrics/measures/mean_error.h"
#include "metrics/prepared_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

// The exponents of the paper's section 3.2, finest scale first.
constexpr std::array<double, kSimilarityScales> kExponents = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

/// Adds the influence of each block on exponent * log(mean of a factor).
void add_influences(std::vector<double>& influences, const std::vector<double>& sums,
                    const std::vector<double>& weights, double exponent) {
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    const double weight = std::accumulate(weights.begin(), weights.end(), 0.0);
    influences.resize(sums.size());
    for (std::size_t b = 0; b < sums.size(); ++b)
        influences[b] += exponent * (sums[b] / sum - weights[b] / weight);
}

}  // namespace

MetricValue measure::ms_ssim(const MetricInput& input) {
    if (!has_valid_pixel(input)) return undefined(kNoValidPixel);
    if (std::min(input.truth.width, input.truth.height) < kSmallestSide_px) {
        return undefined(fmt::format("the image is smaller than {0}x{0} px", kSmallestSide_px));
    }
    const BlockGrid grid = similarity_squares(input.valid);
    std::vector<double> influences;
    double product = 1;
    bool anticorrelated = false;
    ScaledImage truth(input.truth, input.prepared_truth), test(input.test, input.prepared_test);
    PixelWeights weights(input.valid);
    for (std::size_t scale = 0; scale < kExponents.size(); ++scale) {
        if (scale > 0) {
            truth.halve(weights);
            test.halve(weights);
            weights = weights.halved();
        }
        const SsimSums sums = scale == 0 ? finest_similarity(input).by_square
                                         : structural_similarity(truth.windowed(), test.windowed(), weights,
                                                                 {&grid, 1}, static_cast<int>(scale))[0];
        const std::optional<SsimMeans> means = sums.means();
        if (!means)
            return undefined(fmt::format("no valid pixel {} px inside the border at 1/{} size",
                                         kSsimBorder_px, 1 << scale));
        const bool coarsest = scale + 1 == kExponents.size();
        const double factor = coarsest ? means->ssim : means->contrast_structure;
        if (!std::isfinite(factor)) return undefined(kNotFinite);
        anticorrelated = anticorrelated || factor < 0;
        product *= std::pow(std::max(factor, 0.0), kExponents[scale]);  // a negative base has no real power
        if (!anticorrelated && factor > 0)
            add_influences(influences, coarsest ? sums.ssim : sums.contrast_structure, sums.weights,
                           kExponents[scale]);
    }
    if (input.maps != nullptr && product > 0 && grid.size() >= kFewestBlocks) {
        input.maps->ms_ssim = product;
        input.maps->ms_ssim_influences = std::move(influences);
    }
    return defined(product, anticorrelated ? "taken as 0: structure is anticorrelated at some scale" : "");
}

}  // namespace aoscore
