#include "metrics/prepared_halves.h"

#include <cmath>
#include <cstddef>

namespace aoscore {
namespace {

/// Half the difference of the halves, scaled so that its variance is so many times that.
ImageF noise_of(const ImageF& first, const ImageF& second, double times) {
    const auto scale = static_cast<float>(std::sqrt(times) / 2);
    ImageF noise(first.width, first.height);
    for (std::size_t i = 0; i < noise.size(); ++i)
        noise.pixels[i] = scale * (first.pixels[i] - second.pixels[i]);
    return noise;
}

}  // namespace

PreparedHalves::PreparedHalves(const ImageF& mean, const ImageF& first_half, const ImageF& second_half,
                               const Mask& valid)
    : whole(mean, valid, noise_of(first_half, second_half, 1), true),
      first(first_half, valid, noise_of(first_half, second_half, 2)),
      second(second_half, valid, noise_of(first_half, second_half, 2)) {}

}  // namespace aoscore
