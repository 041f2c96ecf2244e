#include "metrics/measures/flip_filter.h"

#include "metrics/measures/convolution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

// The paper's viewing conditions: 0.7 m from a 4K monitor 0.7 m wide.
constexpr double kPixelsPerDegree = 67.02;
// Table 1 for the achromatic channel, the only one of a gray. The paper samples it as far as the widest
// channel reaches, 10 pixels; beyond 7 the weights are below 2e-13.
constexpr double kLuminanceSpread = 0.0047;
constexpr std::size_t kContrastReach_px = 7;
constexpr double kFeatureWidth_deg = 0.082;

/// The weights of the middle and of the pixels right of it or below; those on the other side are the same, or
/// their negatives.
using HalfKernel = std::array<double, FlipFilter::kMargin_px + 1>;

template <class F>
HalfKernel sampled(F value_at) {
    HalfKernel kernel;
    for (std::size_t x = 0; x < kernel.size(); ++x) kernel[x] = value_at(static_cast<double>(x));
    return kernel;
}

/// An even kernel with positive weights scaled to a sum of 1, negative ones to -1.
HalfKernel balanced(HalfKernel kernel) {
    double positive = 0, negative = 0;
    for (std::size_t x = 0; x < kernel.size(); ++x)
        (kernel[x] > 0 ? positive : negative) += (x == 0 ? 1 : 2) * std::abs(kernel[x]);
    for (double& w : kernel) {
        if (w != 0) w /= w > 0 ? positive : negative;
    }
    return kernel;
}

/// An odd kernel with each side scaled to a sum of 1.
HalfKernel balanced_side(HalfKernel kernel) {
    double sum = 0;
    for (const double w : kernel) sum += std::abs(w);
    for (double& w : kernel) w /= sum;
    return kernel;
}

struct Kernels {
    HalfKernel contrast;             ///< contrast sensitivity to luminance
    HalfKernel smooth, edge, point;  ///< a Gaussian and its first and second derivative

    Kernels() {
        contrast = balanced(sampled([](double x) {
            const double degrees = x / kPixelsPerDegree;
            if (x > double{kContrastReach_px}) return 0.0;
            return std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / kLuminanceSpread);
        }));
        const double sigma_px = 0.5 * kFeatureWidth_deg * kPixelsPerDegree;
        assert(std::ceil(3 * sigma_px) == FlipFilter::kMargin_px);
        const auto gaussian = [=](double x) { return std::exp(-x * x / (2 * sigma_px * sigma_px)); };
        smooth = balanced(sampled(gaussian));
        edge = balanced_side(sampled([=](double x) { return -x * gaussian(x); }));
        point =
            balanced(sampled([=](double x) { return (x * x / (sigma_px * sigma_px) - 1) * gaussian(x); }));
    }
};

const Kernels& kernels() {
    static const Kernels all;
    return all;
}

constexpr std::size_t kReach = FlipFilter::kMargin_px;

/// A row filtered down in every way.
struct DownRow {
    double *contrast, *smooth, *edge, *point;
};

AOSCORE_WIDER_WHERE_POSSIBLE
void filter_down(const std::array<const double*, FlipFilter::kRows>& rows, const DownRow& to,
                 std::size_t count) {
    const Kernels& k = kernels();
    const HalfFilter odd{to.edge, k.edge.data()};
    const HalfFilter even[] = {
        {to.contrast, k.contrast.data()}, {to.smooth, k.smooth.data()}, {to.point, k.point.data()}};
    lanes::all_sums<2, kReach, 1, 3>(
        count, [&rows](std::size_t i) { return rows[i]; }, &odd, even);
}

// These filter across a row with its margins.

AOSCORE_WIDER_WHERE_POSSIBLE
void contrast_across(const double* row, double* to, std::size_t count) {
    const HalfFilter contrast{to, kernels().contrast.data()};
    const double* from = row + (kReach - kContrastReach_px);
    lanes::all_sums<4, kContrastReach_px, 0, 1>(
        count, [from](std::size_t i) { return from + i; }, nullptr, &contrast);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void smooth_across(const double* row, double* to, std::size_t count) {
    const HalfFilter smooth{to, kernels().smooth.data()};
    lanes::all_sums<4, kReach, 0, 1>(
        count, [row](std::size_t i) { return row + i; }, nullptr, &smooth);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void derive_across(const double* row, double* edge, double* point, std::size_t count) {
    const HalfFilter odd{edge, kernels().edge.data()}, even{point, kernels().point.data()};
    lanes::all_sums<2, kReach, 1, 1>(
        count, [row](std::size_t i) { return row + i; }, &odd, &even);
}

}  // namespace

FlipFilter::FlipFilter(std::size_t width)
    : width_(width),
      with_margins_(width + 2 * kMargin_px),
      kept_(kRows * with_margins_),
      down_(kDowns * with_margins_),
      responses_(kResponses * width) {}

std::span<double> FlipFilter::push() {
    return {&kept_[pushed_++ % kRows * with_margins_], with_margins_};
}

void FlipFilter::respond() {
    assert(pushed_ >= kRows);
    std::array<const double*, kRows> rows{};
    for (std::size_t i = 0; i < kRows; ++i) rows[i] = row(pushed_ + i);
    const auto response = [this](Response which) { return (*this)[which].data(); };
    filter_down(rows, {down(kContrast), down(kSmooth), down(kEdge), down(kPoint)}, with_margins_);
    contrast_across(down(kContrast), response(kSeen), width_);
    derive_across(down(kSmooth), response(kEdgeX), response(kPointX), width_);
    smooth_across(down(kEdge), response(kEdgeY), width_);
    smooth_across(down(kPoint), response(kPointY), width_);
}

}  // namespace aoscore
