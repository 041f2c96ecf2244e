#include "metrics/measures/mean_error.h"
#include "metrics/metric.h"

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

}  // namespace aoscore
