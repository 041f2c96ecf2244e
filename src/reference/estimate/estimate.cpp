#include "reference/estimate/estimate.h"

#include "reference/estimate/squared.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// The weight of the tile's law, as it stands about a pixel, against a pixel's own spread, in degrees of
/// freedom. Heavy, so that adaptive tracing cannot stop by a pixel's lucky agreement with itself.
constexpr double kPriorFreedom = 64;
/// This part of a pixel's variance follows the tile's mean instead of its own visibility, which is noisy
/// itself.
constexpr double kSharedPart = 0.3;

/// Squared errors of agreement, times N^2: a x^b + c x^2.
constexpr double kFewMissed = 0.25, kFewMissedPower = 0.75, kManyMissed = 0.09;
/// The prior of a tile, as pixels of it: half a pixel of two agrees.
constexpr double kPriorAgreeing = 0.5, kPriorAlike = 2;
/// Thin occluders are missed so much more often.
constexpr double kMissedThin = 1.9;
/// Where not all rays agree, no less is stated than this over N.
constexpr double kLeastVariance = 0.3 * 0.3;

/// The pixels of one tile that are mostly open, or those that are mostly blocked.
struct Side {
    int alike = 0;     ///< no more than half of whose rays disagree
    int agreeing = 0;  ///< of these, none of whose rays do
    void count(double disagreeing_part) {
        alike += disagreeing_part <= 0.5;
        agreeing += disagreeing_part == 0;
    }
};

/// The variances of one tile's pixels.
class TileVariances {
  public:
    TileVariances(std::span<const PixelSpread> pixels, const TileLawRules& rules)
        : pixels_(pixels), law_(law_of_tile(pixels, rules)), missed_(1 + kMissedThin * law_.thinness) {
        double sum = 0;
        for (const PixelSpread& pixel : pixels) {
            sum += pixel.visibility;
            open_.count(1 - pixel.visibility);
            blocked_.count(pixel.visibility);
        }
        mean_ = (sum + 0.5) / (static_cast<double>(pixels.size()) + 1);
        scales_ = scales_about(pixels, law_, rules);
    }

    /// Of pixel number i of them.
    double of(std::size_t i) {
        const PixelSpread& pixel = pixels_[i];
        if (pixel.samples == 1) return mean_ * (1 - mean_);
        if (pixel.visibility == 1) return of_agreement(pixel.samples, open_);
        if (pixel.visibility == 0) return of_agreement(pixel.samples, blocked_);
        const double least = missed_ * kLeastVariance / squared(pixel.samples);
        return std::max(by_law(pixel, scales_[i]), least);
    }

  private:
    double of_agreement(int samples, const Side& side) const {
        return missed_ * squared(error_of_agreement(samples, side.agreeing, side.alike));
    }

    double by_law(const PixelSpread& pixel, double scale) {
        const double shape = (1 - kSharedPart) * visibility_shape(pixel) + kSharedPart * law_.mean_shape;
        const int freedom = pixel.freedom();
        const double block = (kPriorFreedom * scale * shape * size_shape(pixel) +
                              freedom * block_variance(pixel, law_.ratio)) /
                             (kPriorFreedom + freedom);
        return block * pooled(pixel.samples);
    }

    /// pooled_variance() of the last count that was asked for: pixels of one tile mostly have the same.
    double pooled(int samples) {
        if (samples != samples_) pooled_ = pooled_variance(samples, law_.ratio);
        samples_ = samples;
        return pooled_;
    }

    std::span<const PixelSpread> pixels_;
    TileLaw law_;
    std::vector<double> scales_;
    double missed_;
    Side open_, blocked_;
    double mean_ = 0;  // of visibility
    int samples_ = 0;
    double pooled_ = 0;
};

}  // namespace

double error_of_agreement(int samples, int agreeing, int alike) {
    const double missed = -std::log((agreeing + kPriorAgreeing) / (alike + kPriorAlike));
    return std::sqrt(kFewMissed * std::pow(missed, kFewMissedPower) + kManyMissed * squared(missed)) /
           samples;
}

std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels, const TileLawRules& rules) {
    TileVariances variances(pixels, rules);
    std::vector<Estimate> estimates;
    estimates.reserve(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        estimates.push_back({pixels[i].visibility, std::min(std::sqrt(variances.of(i)), 0.5)});
    return estimates;
}

}  // namespace aoscore
