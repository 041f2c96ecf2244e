#include "metrics/measures/seen_rows.h"

#include "metrics/measures/flip_colour.h"
#include "metrics/measures/srgb_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aoscore {
namespace {

constexpr int kMargin_px = FlipFilter::kMargin_px;

std::size_t with_margins(const FlipArea& area) {
    return static_cast<std::size_t>(area.width + 2 * kMargin_px);
}

/// An image's row with a margin: beyond the image its outermost pixels are repeated.
template <class F>
void read_row(std::vector<double>& row, const FlipArea& area, int image_width, F value_at) {
    const int first = area.left - kMargin_px, count = static_cast<int>(row.size());
    const int within = std::clamp(-first, 0, count), end = std::min(count, image_width - first);
    for (int i = 0; i < within; ++i) row[static_cast<std::size_t>(i)] = value_at(0);
    for (int i = within; i < end; ++i) row[static_cast<std::size_t>(i)] = value_at(first + i);
    for (int i = end; i < count; ++i) row[static_cast<std::size_t>(i)] = value_at(image_width - 1);
}

/// Calls push(row) until the filter has the rows that it needs for row `y`.
template <class Push>
void push_until(int y, const FlipArea& area, int image_height, Push push) {
    const int first = y == area.top ? y - kMargin_px : y + kMargin_px;
    for (int row = first; row <= y + kMargin_px; ++row) push(std::clamp(row, 0, image_height - 1));
}

}  // namespace

ValidRows::ValidRows(const Mask& valid, const FlipArea& area) : valid_(valid), area_(area), next_(area.top) {
    if (!has_invalid()) return;
    filter_.emplace(static_cast<std::size_t>(area.width));
    row_.resize(with_margins(area));
}

bool ValidRows::has_invalid() const {
    const int left = std::max(area_.left - kMargin_px, 0);
    const int right = std::min(area_.left + area_.width + kMargin_px, valid_.width);
    const int top = std::max(area_.top - kMargin_px, 0);
    const int bottom = std::min(area_.top + area_.height + kMargin_px, valid_.height);
    for (int y = top; y < bottom; ++y) {
        const std::uint8_t* row = &valid_.at(0, y);
        if (std::find(row + left, row + right, 0) != row + right) return true;
    }
    return false;
}

const FlipFilter* ValidRows::responses(int y) {
    if (!filter_) return nullptr;
    if (y < next_) return &*filter_;
    push_until(y, area_, valid_.height, [&](int row) { push(row); });
    filter_->respond();
    next_ = y + 1;
    return &*filter_;
}

void ValidRows::push(int y) {
    const std::uint8_t* valid = &valid_.at(0, y);
    read_row(row_, area_, valid_.width, [&](int x) { return valid[x] == 0 ? 0.0 : 1.0; });
    filter_->push(row_);
}

FilteredRows::FilteredRows(const ImageF& image, ValidRows& valid)
    : image_(image),
      valid_(valid),
      filter_(static_cast<std::size_t>(valid.area().width)),
      row_(with_margins(valid.area())),
      lightness_(static_cast<std::size_t>(valid.area().width)),
      edges_(lightness_),
      points_(lightness_),
      next_(valid.area().top) {}

void FilteredRows::push(int y) {
    const float* values = &image_.at(0, y);
    const std::uint8_t* valid = &valid_.mask().at(0, y);
    // Values may be NaN where they are invalid.
    read_row(row_, valid_.area(), image_.width,
             [&](int x) { return valid[x] == 0 ? 0.0 : std::clamp(double{values[x]}, 0.0, 1.0); });
    take_srgb_off(row_);
    filter_.push(row_);
}

/// Removes invalid pixels, which were filtered as 0: the mean is over the valid ones, and in a derivative the
/// value of the pixel itself replaces invalid ones, which therefore have no effect.
void FilteredRows::without_invalid(const FlipFilter& valid) {
    using enum FlipFilter::Response;
    const std::span<double> seen = filter_[kSeen];
    const std::span<const double> weights = valid[kSeen];
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (weights[i] > 0) seen[i] /= weights[i];
    }
    const std::span<const double> self = filter_[kSelf];
    for (const auto derivative : {kEdgeX, kEdgeY, kPointX, kPointY}) {
        const std::span<double> values = filter_[derivative];
        const std::span<const double> of_valid = valid[derivative];
        for (std::size_t i = 0; i < values.size(); ++i) values[i] -= self[i] * of_valid[i];
    }
}

void FilteredRows::find_lengths(std::vector<double>& lengths, FlipFilter::Response in_x,
                                FlipFilter::Response in_y) const {
    const double *x = filter_[in_x].data(), *y = filter_[in_y].data();
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

SeenRow FilteredRows::next() {
    using enum FlipFilter::Response;
    push_until(next_, valid_.area(), image_.height, [&](int row) { push(row); });
    filter_.respond();
    if (const FlipFilter* valid = valid_.responses(next_)) without_invalid(*valid);
    ++next_;
    std::ranges::copy(filter_[kSeen], lightness_.begin());
    to_lightness(lightness_);
    find_lengths(edges_, kEdgeX, kEdgeY);
    find_lengths(points_, kPointX, kPointY);
    return {lightness_.data(), edges_.data(), points_.data()};
}

SeenRow StoredRows::next() {
    const std::size_t i = seen_.lightness.index(area_.left, next_++);
    return {&seen_.lightness.pixels[i], &seen_.edges.pixels[i], &seen_.points.pixels[i]};
}

}  // namespace aoscore
