#include "metrics/measures/window_moments.h"

#include "metrics/measures/convolution.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>

namespace aoscore {
namespace {

AOSCORE_WIDER_WHERE_POSSIBLE
void weigh(const double* values, const double* weights, double* terms, double* squares, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        terms[i] = weights[i] * values[i];
        squares[i] = weights[i] * (values[i] * values[i]);
    }
}

AOSCORE_WIDER_WHERE_POSSIBLE
void find_moments(const double* sums, const double* squares, const double* weights, double* mean,
                  double* variance, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        mean[i] = sums[i] / weights[i];
        variance[i] = squares[i] / weights[i] - mean[i] * mean[i];
    }
}

}  // namespace

MovingWeights::MovingWeights(const PixelWeights& weights)
    : weights_(weights),
      filter_(static_cast<std::size_t>(weights.width())),
      row_(static_cast<std::size_t>(weights.width()), 1.0) {}

const std::vector<double>& MovingWeights::push(int y) {
    if (weights_.all_one()) return row_;
    weights_.read_row(y, row_);
    filter_.push(row_.data());
    return row_;
}

const double* MovingWeights::sums() {
    return weights_.all_one() ? row_.data() : filter_.sums();
}

MovingMoments::MovingMoments(std::size_t width)
    : values_(width),
      squares_(width),
      terms_(width),
      squared_terms_(width),
      mean_(width - 2 * kSsimBorder_px),
      variance_(mean_) {}

void MovingMoments::push(const std::vector<double>& values, const std::vector<double>& weights) {
    weigh(values.data(), weights.data(), terms_.data(), squared_terms_.data(), terms_.size());
    values_.push(terms_.data());
    squares_.push(squared_terms_.data());
}

MomentRow MovingMoments::row(const double* weight_sums) {
    find_moments(values_.sums(), squares_.sums(), weight_sums, mean_.data(), variance_.data(), mean_.size());
    return {mean_.data(), variance_.data()};
}

void read_counting(const ImageF& image, int y, const std::vector<double>& weights,
                   std::vector<double>& values) {
    const float* row = &image.at(0, y);
    for (std::size_t x = 0; x < values.size(); ++x) values[x] = weights[x] == 0 ? 0.0 : double{row[x]};
}

WindowMoments window_moments(const ImageF& image, const PixelWeights& weights) {
    constexpr int kBorders_px = 2 * kSsimBorder_px;
    const int width = image.width - kBorders_px, height = image.height - kBorders_px;
    WindowMoments all{Image<double>(width, height), Image<double>(width, height)};
    for_each_band(height, [&](std::size_t, int first_row, int rows) {
        MovingWeights moving_weights(weights);
        MovingMoments moments(static_cast<std::size_t>(image.width));
        std::vector<double> values(static_cast<std::size_t>(image.width));
        for (int y = 0; y < rows + kBorders_px; ++y) {
            const std::vector<double>& row_weights = moving_weights.push(first_row + y);
            read_counting(image, first_row + y, row_weights, values);
            moments.push(values, row_weights);
            if (y < kBorders_px) continue;
            const MomentRow row = moments.row(moving_weights.sums());
            std::copy_n(row.mean, width, &all.mean.at(0, first_row + y - kBorders_px));
            std::copy_n(row.variance, width, &all.variance.at(0, first_row + y - kBorders_px));
        }
    });
    return all;
}

}  // namespace aoscore
