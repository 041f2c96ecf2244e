#include "reference/estimate.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// The weight of the tile's common law against a pixel's own spread, in degrees of freedom: keeps the errors
/// of pixels that differ from their neighbours within 10 % in tests, while their scores become close to
/// normal.
constexpr double kPriorFreedom = 16;

/// Neighbours count the less the more their asin(sqrt(V)), in which binomial noise is even, differs.
constexpr double kLikeness_rad = 0.1;

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
    const std::size_t count = pixels.size();
    std::vector<double> shape(count), place(count);
    for (std::size_t i = 0; i < count; ++i) {
        shape[i] = variance_shape(pixels[i]);
        place[i] = std::asin(std::sqrt(pixels[i].visibility)) / kLikeness_rad;
    }
    std::vector<Estimate> estimates;
    estimates.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        double variances = 0, shapes = 0;
        for (std::size_t j = 0; j < count; ++j) {
            const double apart = place[i] - place[j];
            const double weight = pixels[j].freedom / ((1 + apart * apart) * (1 + apart * apart));
            variances += weight * pixels[j].variance;
            shapes += weight * shape[j];
        }
        const PixelSpread& pixel = pixels[i];
        const double expected = shapes > 0 ? variances / shapes * shape[i] : 0;
        const double variance =
            (kPriorFreedom * expected + pixel.freedom * pixel.variance) / (kPriorFreedom + pixel.freedom);
        const double error =
            pixel.freedom > 0 ? std::max(std::sqrt(variance), standard_error_floor(pixel.samples)) : 0.5;
        estimates.push_back({pixel.visibility, std::min(error, 0.5)});
    }
    return estimates;
}

}  // namespace aoscore
