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
// channel reaches, 10 pixels; beyond the margin the weights are below 1e-16.
constexpr double kLuminanceSpread = 0.0047;
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
    : width_(width), kept_(kKept * kRows * width), responses_(kResponses * width) {}

void FlipFilter::push(std::span<const double> row) {
    assert(row.size() == width_ + 2 * kMargin_px);
    std::array<const double*, kRows> from{};
    for (std::size_t k = 0; k < kRows; ++k) from[k] = row.data() + k;
    const Kernels& k = kernels();
    std::copy_n(row.data() + kMargin_px, width_, kept(kRow, pushed_));
    even_sums(kept(kContrast, pushed_), from, k.contrast, width_);
    even_sums(kept(kSmooth, pushed_), from, k.smooth, width_);
    odd_sums(kept(kEdge, pushed_), from, k.edge, width_);
    even_sums(kept(kPoint, pushed_), from, k.point, width_);
    ++pushed_;
}

std::array<const double*, FlipFilter::kRows> FlipFilter::rows_of(Kept what) {
    std::array<const double*, kRows> rows{};
    for (std::size_t k = 0; k < kRows; ++k) rows[k] = kept(what, pushed_ + k);
    return rows;
}

void FlipFilter::respond() {
    assert(pushed_ >= kRows);
    const Kernels& k = kernels();
    std::copy_n(rows_of(kRow)[kMargin_px], width_, (*this)[kSelf].data());
    even_sums((*this)[kSeen].data(), rows_of(kContrast), k.contrast, width_);
    even_sums((*this)[kEdgeX].data(), rows_of(kEdge), k.smooth, width_);
    odd_sums((*this)[kEdgeY].data(), rows_of(kSmooth), k.edge, width_);
    even_sums((*this)[kPointX].data(), rows_of(kPoint), k.smooth, width_);
    even_sums((*this)[kPointY].data(), rows_of(kSmooth), k.point, width_);
}

}  // namespace aoscore
