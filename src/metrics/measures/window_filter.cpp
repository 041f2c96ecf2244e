#include "metrics/measures/window_filter.h"

#include "metrics/measures/convolution.h"

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

}  // namespace

void WindowFilter::push(const double* row) {
    std::array<const double*, kRows> from{};
    for (std::size_t k = 0; k < kRows; ++k) from[k] = row + k;
    even_sums(from, inner_, {&kept_[pushed_ % kRows * inner_], kHalfWindow.data()});
    ++pushed_;
}

const double* WindowFilter::sums() {
    assert(pushed_ >= kRows);
    std::array<const double*, kRows> from{};
    for (std::size_t k = 0; k < kRows; ++k) from[k] = &kept_[(pushed_ + k) % kRows * inner_];
    even_sums(from, inner_, {sums_.data(), kHalfWindow.data()});
    return sums_.data();
}

}  // namespace aoscore
