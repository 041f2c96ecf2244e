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
      scales_(2 * static_cast<std::size_t>(area.width), 1.0) {}

const std::vector<double>& MovingWeights::push(int y) {
    if (weights_.all_one()) return row_;
    weights_.read_row(left_, y, row_);
    filter_.push(row_.data());
    return row_;
}

RowPair MovingWeights::scales() {
    const std::size_t width = scales_.size() / 2;
    if (!weights_.all_one()) {
        const RowPair sums = filter_.sums();
        for (const std::size_t i : {0U, 1U}) find_scales(sums[i], &scales_[i * width], width);
    }
    return {scales_.data(), scales_.data() + width};
}

MovingMoments::MovingMoments(std::size_t width)
    : values_(width),
      squares_(width),
      terms_(width),
      squared_terms_(width),
      mean_(2 * (width - 2 * kSsimBorder_px)),
      variance_(mean_) {}

void MovingMoments::push(const std::vector<double>& values, const std::vector<double>& weights) {
    weigh(values.data(), weights.data(), terms_.data(), squared_terms_.data(), terms_.size());
    values_.push(terms_.data());
    squares_.push(squared_terms_.data());
}

MomentRows MovingMoments::rows(const RowPair& scales) {
    const RowPair sums = values_.sums(), squares = squares_.sums();
    const std::size_t width = mean_.size() / 2;
    MomentRows rows{};
    for (const std::size_t i : {0U, 1U}) {
        double *mean = &mean_[i * width], *variance = &variance_[i * width];
        find_moments(sums[i], squares[i], scales[i], mean, variance, width);
        rows[i] = {mean, variance};
    }
    return rows;
}

void read_counting(const ImageF& image, int x, int y, const std::vector<double>& weights,
                   std::vector<double>& values) {
    fetch_ahead(image, x, x + static_cast<int>(values.size()), y + kRowsAhead);
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
        const auto push = [&](int y) {
            const std::vector<double>& row_weights = moving_weights.push(y);
            read_counting(image, area.left, y, row_weights, values);
            moments.push(values, row_weights);
        };
        for_each_pair(area, push, [&](int y) {
            const MomentRows rows = moments.rows(moving_weights.scales());
            for (int second = 0; second < std::min(2, area.top + area.height - y); ++second) {
                const MomentRow& row = rows[static_cast<std::size_t>(second)];
                std::copy_n(row.mean, area.width, &all.mean.at(area.left, y + second));
                std::copy_n(row.variance, area.width, &all.variance.at(area.left, y + second));
            }
        });
    });
    return all;
}

}  // namespace aoscore
