#include "metrics/measures/seen_rows.h"

#include "metrics/measures/flip_colour.h"
#include "metrics/measures/srgb_values.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace aoscore {
namespace {

constexpr int kMargin_px = FlipFilter::kMargin_px;

/// Fills an area's row and its margins: read(row, first_x) fills the part within the image, and beyond the
/// image its outermost pixels are repeated.
template <class Read>
void fill_row(std::span<double> row, const ImageArea& area, int image_width, Read read) {
    const int first_x = area.left - kMargin_px;
    const auto begin = static_cast<std::size_t>(std::max(-first_x, 0));
    const std::size_t end = std::min(row.size(), static_cast<std::size_t>(image_width - first_x));
    read(row.subspan(begin, end - begin), first_x + static_cast<int>(begin));
    std::ranges::fill(row.first(begin), row[begin]);
    std::ranges::fill(row.subspan(end), row[end - 1]);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void read_valid(const std::uint8_t* valid, double* row, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) row[i] = valid[i] == 0 ? 0 : 1;
}

/// Reads values, clamped to [0,1], as luminances: as integers floats have the same order from 0 on, and
/// negative ones are negative.
AOSCORE_WIDER_WHERE_POSSIBLE
void read_luminances(const float* values, double* row, std::size_t count) {
    constexpr std::int32_t kOne = std::bit_cast<std::int32_t>(1.0F);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t clamped = std::min(std::max(std::bit_cast<std::int32_t>(values[i]), 0), kOne);
        row[i] = lanes::linear_from_srgb(double{std::bit_cast<float>(clamped)});
    }
}

/// Replaces values of invalid pixels, which may be NaN, by 0.
AOSCORE_WIDER_WHERE_POSSIBLE
void clear_invalid(const std::uint8_t* valid, double* row, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) row[i] = valid[i] == 0 ? 0.0 : row[i];
}

/// Replaces invalid pixels, which were filtered as 0, by the value of the pixel itself: in a derivative they
/// then have no effect.
AOSCORE_WIDER_WHERE_POSSIBLE
void add_own_value(double* derivative, const double* of_valid, const double* own, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) derivative[i] -= own[i] * of_valid[i];
}

/// Divides sums over valid pixels by their weights; 0 stays where there is none.
AOSCORE_WIDER_WHERE_POSSIBLE
void divide_by_weights(double* sums, const double* weights, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) sums[i] /= weights[i] > 0 ? weights[i] : 1.0;
}

/// Calls push(row) until the filter has the rows that it needs for row `y`.
template <class Push>
void push_until(int y, const ImageArea& area, int image_height, Push push) {
    const int first = y == area.top ? y - kMargin_px : y + kMargin_px;
    for (int row = first; row <= y + kMargin_px; ++row) push(std::clamp(row, 0, image_height - 1));
}

}  // namespace

ValidRows::ValidRows(const Mask& valid, const ImageArea& area) : valid_(valid), area_(area), next_(area.top) {
    if (has_invalid()) filter_.emplace(static_cast<std::size_t>(area.width));
}

bool ValidRows::has_invalid() const {
    const int left = std::max(area_.left - kMargin_px, 0);
    const int right = std::min(area_.left + area_.width + kMargin_px, valid_.width);
    const int top = std::max(area_.top - kMargin_px, 0);
    const int bottom = std::min(area_.top + area_.height + kMargin_px, valid_.height);
    for (int y = top; y < bottom; ++y) {
        const std::uint8_t* row = &valid_.at(0, y);
        if (!all_count(row + left, static_cast<std::size_t>(right - left))) return true;
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
    fill_row(filter_->push(), area_, valid_.width,
             [&](std::span<double> row, int x) { read_valid(valid + x, row.data(), row.size()); });
}

FilteredRows::FilteredRows(const ImageF& image, ValidRows& valid)
    : image_(image),
      valid_(valid),
      filter_(static_cast<std::size_t>(valid.area().width)),
      lightness_(static_cast<std::size_t>(valid.area().width)),
      edges_(lightness_),
      points_(lightness_),
      next_(valid.area().top) {}

void FilteredRows::push(int y) {
    const ImageArea& area = valid_.area();
    fetch_ahead(image_, area.left - kMargin_px, area.left + area.width + kMargin_px, y + kRowsAhead);
    const float* values = &image_.at(0, y);
    const std::uint8_t* valid = &valid_.mask().at(0, y);
    fill_row(filter_.push(), valid_.area(), image_.width, [&](std::span<double> row, int x) {
        read_luminances(values + x, row.data(), row.size());
        if (!valid_.all_valid()) clear_invalid(valid + x, row.data(), row.size());
    });
}

void FilteredRows::without_invalid(const FlipFilter& valid) {
    using enum FlipFilter::Response;
    const std::size_t width = edges_.size();
    divide_by_weights(filter_[kSeen].data(), valid[kSeen].data(), width);
    for (const auto derivative : {kEdgeX, kEdgeY, kPointX, kPointY})
        add_own_value(filter_[derivative].data(), valid[derivative].data(), filter_.middle().data(), width);
}

SeenRow FilteredRows::next() {
    using enum FlipFilter::Response;
    push_until(next_, valid_.area(), image_.height, [&](int row) { push(row); });
    filter_.respond();
    if (const FlipFilter* valid = valid_.responses(next_)) without_invalid(*valid);
    ++next_;
    const auto from = [this](FlipFilter::Response response) { return filter_[response].data(); };
    find_features({from(kSeen), from(kEdgeX), from(kEdgeY), from(kPointX), from(kPointY)},
                  {lightness_.data(), edges_.data(), points_.data()}, lightness_.size());
    return {lightness_.data(), edges_.data(), points_.data()};
}

SeenRow StoredRows::next() {
    const std::size_t i = seen_.lightness.index(area_.left, next_++);
    return {&seen_.lightness.pixels[i], &seen_.edges.pixels[i], &seen_.points.pixels[i]};
}

}  // namespace aoscore
