#include "metrics/measures/pixel_weights.h"

#include "core/threads.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

std::size_t in_row(int count) {
    return static_cast<std::size_t>(count);
}

/// Calls pixel(x, y, weights of its four pixels) for all of an image at half the size.
template <class Pixel>
void for_each_half(const PixelWeights& weights, Pixel pixel) {
    parallel_for(in_row(weights.height() / 2), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::vector<double> upper(in_row(weights.width())), lower(upper);
        weights.read_row(2 * y, upper);
        weights.read_row(2 * y + 1, lower);
        for (int x = 0; x < weights.width() / 2; ++x) {
            const double* above = &upper[2 * in_row(x)];
            const double* below = &lower[2 * in_row(x)];
            pixel(x, y, {above[0], above[1], below[0], below[1]});
        }
    });
}

struct Corners {
    double of[4];
    double sum() const { return of[0] + of[1] + of[2] + of[3]; }
};

}  // namespace

PixelWeights::PixelWeights(const Mask& valid) : width_(valid.width), height_(valid.height), mask_(&valid) {
    all_one_ = std::ranges::find(valid.pixels, 0) == valid.pixels.end();
}

PixelWeights::PixelWeights(ImageF halved)
    : width_(halved.width), height_(halved.height), halved_(std::move(halved)) {
    all_one_ = std::ranges::all_of(halved_.pixels, [](float weight) { return weight == 1; });
}

void PixelWeights::read_row(int y, std::span<double> weights) const {
    if (mask_ != nullptr) {
        const std::uint8_t* row = &mask_->at(0, y);
        for (std::size_t x = 0; x < weights.size(); ++x) weights[x] = row[x] != 0 ? 1 : 0;
    } else {
        std::copy_n(&halved_.at(0, y), weights.size(), weights.begin());
    }
}

PixelWeights PixelWeights::halved() const {
    ImageF half(width_ / 2, height_ / 2);
    for_each_half(*this, [&](int x, int y, const Corners& weights) {
        half.at(x, y) = static_cast<float>(weights.sum() / 4);
    });
    return PixelWeights(std::move(half));
}

ImageF PixelWeights::halved(const ImageF& image) const {
    ImageF half(width_ / 2, height_ / 2);
    for_each_half(*this, [&](int x, int y, const Corners& weights) {
        const float* above = &image.at(2 * x, 2 * y);
        const float* below = &image.at(2 * x, 2 * y + 1);
        const float values[] = {above[0], above[1], below[0], below[1]};
        double sum = 0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            if (weights.of[corner] != 0) sum += weights.of[corner] * double{values[corner]};
        }
        if (weights.sum() > 0) half.at(x, y) = static_cast<float>(sum / weights.sum());
    });
    return half;
}

}  // namespace aoscore
