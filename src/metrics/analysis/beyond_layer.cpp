#include "metrics/analysis/beyond_layer.h"

#include "metrics/analysis/repeat_values.h"

#include <algorithm>

namespace aoscore {

std::optional<double> found_beyond_layer(const MetricInput& input, const ImageF& one_layer) {
    HiddenOcclusion occlusion{input.truth, input.truth};
    for (std::size_t i = 0; i < one_layer.size(); ++i) {
        occlusion.whole.pixels[i] = 1 - input.truth.pixels[i];
        occlusion.hidden.pixels[i] = std::max(occlusion.whole.pixels[i] - one_layer.pixels[i], 0.0F);
    }
    return found_share(found_occlusion(occlusion, input.test, input.valid, Findings::within_hidden));
}

}  // namespace aoscore
