#include "metrics/prepared_image.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

/// No variance is taken to be less, where it came out negative by chance: near -C2 SSIM would be anything.
/// Cut off at 0, chance would make variances too large on average and SSIM too low, by up to a sixth of what
/// the noise did to it on pictures that are flat; cut off lower, the remaining outliers make it too high.
constexpr double kLeastVariance = -kSsimC2 / 4;

void take_off(const Image<double>& noise, Image<double>& variance) {
    for (std::size_t i = 0; i < variance.size(); ++i)
        variance.pixels[i] = std::max(variance.pixels[i] - noise.pixels[i], kLeastVariance);
}

}  // namespace

const SeenImage& PreparedImage::seen() const {
    if (!seen_) seen_ = seen_image(image_, valid_);
    return *seen_;
}

const ImageF& PreparedImage::image_at(std::size_t halvings) const {
    return halvings == 0 ? image_ : scales_[halvings].halved;
}

void PreparedImage::add_scale() const {
    Scale scale;
    if (scales_.empty()) {
        weights_.emplace(valid_);
    } else {
        scale.halved = weights_->halved(image_at(scales_.size() - 1));
        if (noise_) noise_ = weights_->halved(*noise_);
        weights_ = weights_->halved();
    }
    scales_.push_back(std::move(scale));
    const ImageF& image = image_at(scales_.size() - 1);
    if (std::min(image.width, image.height) <= 2 * kSsimBorder_px) return;
    WindowMoments& moments = scales_.back().moments.emplace(window_moments(image, *weights_));
    if (keeps_noisy_ && scales_.size() == 1) scales_.back().noisy_variance = moments.variance;
    if (noise_) take_off(window_moments(*noise_, *weights_).variance, moments.variance);
}

WindowedImage PreparedImage::windowed(std::size_t halvings) const {
    while (scales_.size() <= halvings) add_scale();
    const Scale& scale = scales_[halvings];
    return {image_at(halvings), scale.moments ? &*scale.moments : nullptr,
            scale.noisy_variance ? &*scale.noisy_variance : nullptr};
}

WindowedImage ScaledImage::windowed() const {
    if (prepared_ != nullptr) return prepared_->windowed(halvings_);
    return {halvings_ == 0 ? image_ : halved_};
}

void ScaledImage::halve(const PixelWeights& weights) {
    if (prepared_ == nullptr) halved_ = weights.halved(windowed().image);
    ++halvings_;
}

}  // namespace aoscore
