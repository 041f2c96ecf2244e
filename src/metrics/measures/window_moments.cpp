#include "metrics/measures/window_moments.h"

#include "core/threads.h"
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
void find_moments(const double* sums, const double* squares, const double* scales, double* mean,
                  double* variance, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double m = sums[i] * scales[i];
        mean[i] = m;
        variance[i] = squares[i] * scales[i] - m * m;
    }
}

AOSCORE_WIDER_WHERE_POSSIBLE
void find_scales(const double* sums, double* scales, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) scales[i] = 1 / sums[i];
}

AOSCORE_WIDER_WHERE_POSSIBLE
void find_counting(const float* row, const double* weights, double* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) values[i] = weights[i] == 0 ? 0.0 : double{row[i]};
}

std::size_t with_borders(const ImageArea& area) {
    return static_cast<std::size_t>(area.width + 2 * kSsimBorder_px);
}

}  // namespace

std::vector<ImageArea> windowed_areas(int image_width, int image_height) {
    return image_areas(image_width - 2 * kSsimBorder_px, image_height - 2 * kSsimBorder_px);
}

MovingWeights::MovingWeights(const PixelWeights& weights, const ImageArea& area)
    : weights_(weights),
      left_(area.left),
      filter_(with_borders(area)),
      row_(with_borders(area), 1.0),
      scales_(static_cast<std::size_t>(area.width), 1.0) {}

const std::vector<double>& MovingWeights::push(int y) {
    if (weights_.all_one()) return row_;
    weights_.read_row(left_, y, row_);
    filter_.push(row_.data());
    return row_;
}

const double* MovingWeights::scales() {
    if (!weights_.all_one()) find_scales(filter_.sums(), scales_.data(), scales_.size());
    return scales_.data();
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

MomentRow MovingMoments::row(const double* scales) {
    find_moments(values_.sums(), squares_.sums(), scales, mean_.data(), variance_.data(), mean_.size());
    return {mean_.data(), variance_.data()};
}

void read_counting(const ImageF& image, int x, int y, const std::vector<double>& weights,
                   std::vector<double>& values) {
    find_counting(&image.at(x, y), weights.data(), values.data(), values.size());
}

WindowMoments window_moments(const ImageF& image, const PixelWeights& weights) {
    constexpr int kBorders_px = 2 * kSsimBorder_px;
    const int width = image.width - kBorders_px, height = image.height - kBorders_px;
    WindowMoments all{Image<double>(width, height), Image<double>(width, height)};
    const std::vector<ImageArea> areas = windowed_areas(image.width, image.height);
    parallel_for(areas.size(), [&](std::size_t i) {
        const ImageArea& area = areas[i];
        MovingWeights moving_weights(weights, area);
        MovingMoments moments(with_borders(area));
        std::vector<double> values(with_borders(area));
        for (int y = area.top; y < area.top + area.height + kBorders_px; ++y) {
            const std::vector<double>& row_weights = moving_weights.push(y);
            read_counting(image, area.left, y, row_weights, values);
            moments.push(values, row_weights);
            if (y < area.top + kBorders_px) continue;
            const MomentRow row = moments.row(moving_weights.scales());
            std::copy_n(row.mean, area.width, &all.mean.at(area.left, y - kBorders_px));
            std::copy_n(row.variance, area.width, &all.variance.at(area.left, y - kBorders_px));
        }
    });
    return all;
}

}  // namespace aoscore
