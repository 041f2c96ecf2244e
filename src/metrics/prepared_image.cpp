#include "metrics/prepared_image.h"

#include <algorithm>
#include <utility>

namespace aoscore {

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
        weights_ = weights_->halved();
    }
    scales_.push_back(std::move(scale));
    const ImageF& image = image_at(scales_.size() - 1);
    if (std::min(image.width, image.height) > 2 * kSsimBorder_px)
        scales_.back().moments = window_moments(image, *weights_);
}

WindowedImage PreparedImage::windowed(std::size_t halvings) const {
    while (scales_.size() <= halvings) add_scale();
    const std::optional<WindowMoments>& moments = scales_[halvings].moments;
    return {image_at(halvings), moments ? &*moments : nullptr};
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
