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

template <std::size_t reach>
std::array<const double*, 2 * reach + 1> FlipFilter::around(Down what) {
    std::array<const double*, 2 * reach + 1> shifted{};
    for (std::size_t k = 0; k < shifted.size(); ++k) shifted[k] = down(what) + kMargin_px - reach + k;
    return shifted;
}

void FlipFilter::respond() {
    assert(pushed_ >= kRows);
    const auto half = [](const HalfKernel& kernel) { return kernel.data(); };
    const auto to = [this](Response response) { return (*this)[response].data(); };
    const Kernels& k = kernels();
    std::array<const double*, kRows> rows{};
    for (std::size_t i = 0; i < kRows; ++i) rows[i] = row(pushed_ + i);
    odd_and_even_sums(rows, with_margins_, {down(kEdge), half(k.edge)},
                      {{down(kContrast), half(k.contrast)},
                       {down(kSmooth), half(k.smooth)},
                       {down(kPoint), half(k.point)}});
    even_sums(around<kContrastReach_px>(kContrast), width_, {to(kSeen), half(k.contrast)});
    odd_and_even_sums(around<kMargin_px>(kSmooth), width_, {to(kEdgeX), half(k.edge)},
                      {to(kPointX), half(k.point)});
    even_sums(around<kMargin_px>(kEdge), width_, {to(kEdgeY), half(k.smooth)});
    even_sums(around<kMargin_px>(kPoint), width_, {to(kPointY), half(k.smooth)});
}

}  // namespace aoscore
