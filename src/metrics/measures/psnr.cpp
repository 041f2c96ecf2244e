#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

#include <cmath>

namespace aoscore {

MetricValue measure::psnr(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    if (!mse) return undefined(kNoValidPixel);
    if (*mse == 0) return undefined("the images are identical");
    return defined(-10 * std::log10(*mse));  // the peak is 1 for all images
}

}  // namespace aoscore
