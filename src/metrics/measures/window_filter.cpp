#include "metrics/measures/window_filter.h"

#include "metrics/measures/convolution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace aoscore {
namespace {

/// The weights of the middle of the window's row and of the pixels right of it.
std::array<double, kSsimBorder_px + 1> half_gaussian_window() {
    std::array<double, kSsimBorder_px + 1> half{};
    double sum = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
        const double distance = static_cast<double>(i) / 1.5;
        half[i] = std::exp(-0.5 * distance * distance);
        sum += (i == 0 ? 1 : 2) * half[i];
    }
    for (double& value : half) value /= sum;
    return half;
}

const std::array<double, kSsimBorder_px + 1> kHalfWindow = half_gaussian_window();

AOSCORE_WIDER_WHERE_POSSIBLE
void sum_across(const double* row, double* sums, std::size_t count) {
    const HalfFilter window{sums, kHalfWindow.data()};
    lanes::all_sums<4, kSsimBorder_px, 0, 1>(
        count, [row](std::size_t k) { return row + k; }, nullptr, &window);
}

/// Sums the rows from the first on, and those from the second on, a few pixels of both at a time: what the
/// second sum reads is then still in the nearest cache.
AOSCORE_WIDER_WHERE_POSSIBLE
void sum_down(const WindowFilter::Rows& rows, double* upper, double* lower, std::size_t count) {
    constexpr std::size_t kPart = 64;
    for (std::size_t begin = 0; begin < count; begin += kPart) {
        const std::size_t part = std::min(kPart, count - begin);
        const HalfFilter first{upper + begin, kHalfWindow.data()}, second{lower + begin, kHalfWindow.data()};
        lanes::all_sums<4, kSsimBorder_px, 0, 1>(
            part, [&](std::size_t k) { return rows[k] + begin; }, nullptr, &first);
        lanes::all_sums<4, kSsimBorder_px, 0, 1>(
            part, [&](std::size_t k) { return rows[k + 1] + begin; }, nullptr, &second);
    }
}

}  // namespace

void WindowFilter::push(const double* row) {
    sum_across(row, &kept_[pushed_ % kRows * inner_], inner_);
    ++pushed_;
}

RowPair WindowFilter::sums() {
    assert(pushed_ >= kRows);
    Rows rows;
    for (std::size_t k = 0; k < kRows; ++k) rows[k] = &kept_[(pushed_ + k) % kRows * inner_];
    const RowPair pair{sums_.data(), sums_.data() + inner_};
    sum_down(rows, sums_.data(), sums_.data() + inner_, inner_);
    return pair;
}

}  // namespace aoscore
