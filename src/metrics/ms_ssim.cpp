#include "metrics/mean_error.h"
#include "metrics/measures.h"
#include "metrics/structural_similarity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aoscore {
namespace {

// Finest scale first: table of the paper's section 3.2.
constexpr std::array<double, 5> kExponents = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
constexpr int kSmallestSide_px = (2 * kSsimBorder_px + 1) << (kExponents.size() - 1);

struct WeightedPair {
    ImageF truth, test, weight;
};

/// Half the size (an odd last row or column is dropped): weighted means of 2x2 pixels, and their mean weight.
WeightedPair halved(const WeightedPair& pair) {
    const int width = pair.truth.width / 2, height = pair.truth.height / 2;
    WeightedPair half{ImageF(width, height), ImageF(width, height), ImageF(width, height)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double weight = 0, truth = 0, test = 0;
            for (int corner = 0; corner < 4; ++corner) {
                const std::size_t i = pair.truth.index(2 * x + corner % 2, 2 * y + corner / 2);
                const double w = pair.weight.pixels[i];
                if (w == 0) continue;  // The values may be NaN there.
                weight += w;
                truth += w * pair.truth.pixels[i];
                test += w * pair.test.pixels[i];
            }
            if (weight == 0) continue;
            half.weight.at(x, y) = static_cast<float>(weight / 4);
            half.truth.at(x, y) = static_cast<float>(truth / weight);
            half.test.at(x, y) = static_cast<float>(test / weight);
        }
    }
    return half;
}

}  // namespace

MetricValue measure::ms_ssim(const MetricInput& input) {
    if (!has_valid_pixel(input)) return undefined(kNoValidPixel);
    if (std::min(input.truth.width, input.truth.height) < kSmallestSide_px) {
        return undefined(fmt::format("the image is smaller than {0}x{0} px", kSmallestSide_px));
    }
    double product = 1;
    bool anticorrelated = false;
    WeightedPair pair{input.truth, input.test, weights_of(input.valid)};
    for (std::size_t scale = 0; scale < kExponents.size(); ++scale) {
        if (scale > 0) pair = halved(pair);
        const std::optional<SsimMeans> means = structural_similarity(pair.truth, pair.test, pair.weight);
        if (!means)
            return undefined(fmt::format("no valid pixel {} px inside the border at 1/{} size",
                                         kSsimBorder_px, 1 << scale));
        const bool coarsest = scale + 1 == kExponents.size();
        const double factor = coarsest ? means->ssim : means->contrast_structure;
        if (!std::isfinite(factor)) return undefined(kNotFinite);
        anticorrelated = anticorrelated || factor < 0;
        product *= std::pow(std::max(factor, 0.0), kExponents[scale]);  // A negative base has no real power.
    }
    return defined(product, anticorrelated ? "taken as 0: structure is anticorrelated at some scale" : "");
}

}  // namespace aoscore
