#include "reference/estimate.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// The weight of the tile's common law against a pixel's own spread, in degrees of freedom: keeps the errors
/// of pixels that differ from their neighbours within 10 % in tests, while their scores become close to
/// normal.
constexpr double kPriorFreedom = 12;

/// The shape of the variance over visibility and sample count, up to a factor.
double variance_shape(const PixelSpread& pixel) {
    const double v = pixel.visibility;
    return std::sqrt(v * (1 - v) + 0.5 / pixel.samples) * std::pow(pixel.samples, -1.5);
}

}  // namespace

PixelSpread pixel_spread(std::span<const double> darkening_sums, int samples) {
    double total = 0;
    for (const double sum : darkening_sums) total += sum;
    const double mean = total / samples;
    PixelSpread pixel;
    pixel.samples = samples;
    pixel.visibility = std::clamp(1 - mean, 0.0, 1.0);

    const int sets = std::min(static_cast<int>(darkening_sums.size()), samples);
    pixel.freedom = sets - 1;
    if (sets < 2) return pixel;
    double spread = 0;
    for (int set = 0; set < sets; ++set) {
        const int size = samples / sets + (set < samples % sets ? 1 : 0);
        const double deviation = darkening_sums[static_cast<std::size_t>(set)] / size - mean;
        spread += size * deviation * deviation;
    }
    pixel.variance = spread / (static_cast<double>(pixel.freedom) * samples);
    return pixel;
}

std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels) {
    double variance_sum = 0, shape_sum = 0;
    for (const PixelSpread& pixel : pixels) {
        variance_sum += pixel.freedom * pixel.variance;
        shape_sum += pixel.freedom * variance_shape(pixel);
    }
    const double common = shape_sum > 0 ? variance_sum / shape_sum : 0;
    std::vector<Estimate> estimates;
    estimates.reserve(pixels.size());
    for (const PixelSpread& pixel : pixels) {
        const double own = pixel.freedom * pixel.variance;
        const double variance =
            (kPriorFreedom * common * variance_shape(pixel) + own) / (kPriorFreedom + pixel.freedom);
        const double error =
            pixel.freedom > 0 ? std::max(std::sqrt(variance), standard_error_floor(pixel.samples)) : 0.5;
        estimates.push_back({pixel.visibility, std::min(error, 0.5)});
    }
    return estimates;
}

}  // namespace aoscore
