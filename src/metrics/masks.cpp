#include "metrics/mean_error.h"
#include "metrics/metric.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite) {
    require_one_size({truth, test, candidate});
    nonfinite = 0;
    Mask finite(truth.width, truth.height);
    for (std::size_t i = 0; i < finite.size(); ++i) {
        if (candidate.pixels[i] == 0) continue;
        if (std::isfinite(truth.pixels[i]) && std::isfinite(test.pixels[i])) {
            finite.pixels[i] = 1;
        } else {
            ++nonfinite;
        }
    }
    return finite;
}

OcclusionMasks occlusion_masks(const MetricInput& input, double threshold) {
    require_one_size(input);
    OcclusionMasks masks{Mask(input.truth.width, input.truth.height),
                         Mask(input.truth.width, input.truth.height)};
    std::size_t valid = 0, missing = 0, false_occlusion = 0;
    for (std::size_t i = 0; i < input.truth.size(); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        ++valid;
        const double difference = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        missing += masks.missing.pixels[i] = difference > threshold ? 1 : 0;
        false_occlusion += masks.false_occlusion.pixels[i] = difference < -threshold ? 1 : 0;
    }
    const double count = static_cast<double>(std::max<std::size_t>(valid, 1));
    masks.missing_area = static_cast<double>(missing) / count;
    masks.false_area = static_cast<double>(false_occlusion) / count;
    return masks;
}

}  // namespace aoscore
