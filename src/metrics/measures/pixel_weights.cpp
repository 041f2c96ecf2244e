#include "metrics/measures/pixel_weights.h"

#include "core/threads.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

std::size_t in_row(int count) {
    return static_cast<std::size_t>(count);
}

/// Calls row(y, weights of its upper row, of its lower row) for all rows of an image at half the size.
template <class Row>
void for_each_half_row(const PixelWeights& weights, Row row) {
    parallel_for(in_row(weights.height() / 2), [&](std::size_t half_row) {
        const int y = static_cast<int>(half_row);
        std::vector<double> upper(in_row(weights.width())), lower(upper);
        weights.read_row(0, 2 * y, upper);
        weights.read_row(0, 2 * y + 1, lower);
        row(y, upper.data(), lower.data());
    });
}

/// The mean of four pixels where all of them count.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_means(const float* above, const float* below, float* half, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        const double sum =
            double{above[2 * x]} + double{above[2 * x + 1]} + double{below[2 * x]} + double{below[2 * x + 1]};
        half[x] = static_cast<float>(sum / 4);
    }
}

/// The mean of four pixels by weight; 0 where none counts. Pixels of weight 0 may be NaN.
float weighted_mean(const float* above, const float* below, const double* upper, const double* lower) {
    const double weights[] = {upper[0], upper[1], lower[0], lower[1]};
    const float values[] = {above[0], above[1], below[0], below[1]};
    double sum = 0, weight = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        if (weights[corner] != 0) sum += weights[corner] * double{values[corner]};
        weight += weights[corner];
    }
    return weight > 0 ? static_cast<float>(sum / weight) : 0.0F;
}

}  // namespace

PixelWeights::PixelWeights(const Mask& valid) : width_(valid.width), height_(valid.height), mask_(&valid) {
    all_one_ = all_count(valid.pixels.data(), valid.size());
}

PixelWeights::PixelWeights(ImageF halved)
    : width_(halved.width), height_(halved.height), halved_(std::move(halved)) {
    all_one_ = std::ranges::all_of(halved_.pixels, [](float weight) { return weight == 1; });
}

void PixelWeights::read_row(int x, int y, std::span<double> weights) const {
    if (all_one_) {
        std::ranges::fill(weights, 1.0);
    } else if (mask_ != nullptr) {
        const std::uint8_t* row = &mask_->at(x, y);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = row[i] != 0 ? 1 : 0;
    } else {
        std::copy_n(&halved_.at(x, y), weights.size(), weights.begin());
    }
}

PixelWeights PixelWeights::halved() const {
    if (all_one_) return {width_ / 2, height_ / 2};
    ImageF half(width_ / 2, height_ / 2);
    for_each_half_row(*this, [&](int y, const double* upper, const double* lower) {
        float* row = &half.at(0, y);
        for (std::size_t x = 0; x < in_row(half.width); ++x)
            row[x] =
                static_cast<float>((upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1]) / 4);
    });
    return PixelWeights(std::move(half));
}

ImageF PixelWeights::halved(const ImageF& image) const {
    ImageF half(width_ / 2, height_ / 2);
    if (all_one_) {
        parallel_for(in_row(half.height), [&](std::size_t row) {
            const int y = static_cast<int>(row);
            find_means(&image.at(0, 2 * y), &image.at(0, 2 * y + 1), &half.at(0, y), in_row(half.width));
        });
        return half;
    }
    for_each_half_row(*this, [&](int y, const double* upper, const double* lower) {
        const float *above = &image.at(0, 2 * y), *below = &image.at(0, 2 * y + 1);
        for (int x = 0; x < half.width; ++x)
            half.at(x, y) = weighted_mean(above + 2 * x, below + 2 * x, upper + 2 * x, lower + 2 * x);
    });
    return half;
}

}  // namespace aoscore
