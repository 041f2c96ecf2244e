#include "core/srgb.h"
#include "core/threads.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures.h"
#include "metrics/measures/convolution.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

// After Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild,
// "FLIP: A Difference Evaluator for Alternating Images", 2020, for gray images. A gray stays gray under the
// paper's filters: both opponent channels are 0, and all of it can be done on the luminance (its channel Yy
// is 116 Y - 16).
namespace aoscore {
namespace {

constexpr double kPixelsPerDegree =
    67.02;  // The paper's viewing conditions: 0.7 m from a 4K monitor 0.7 m wide.
constexpr double kColorExponent = 0.7, kFeatureExponent = 0.5;
constexpr double kColorKnee = 0.4, kColorAtKnee = 0.95;
constexpr double kFeatureWidth_deg = 0.082;

using Kernel = std::vector<double>;

template <class F>
Kernel sampled(int radius_px, F value_at) {
    Kernel kernel;
    for (int x = -radius_px; x <= radius_px; ++x) kernel.push_back(value_at(x));
    return kernel;
}

/// Positive weights scaled to a sum of 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const double w : kernel) (w > 0 ? positive : negative) += std::abs(w);
    for (double& w : kernel) {
        if (w != 0) w /= w > 0 ? positive : negative;
    }
    return kernel;
}

struct Kernels {
    Kernel contrast;           ///< contrast sensitivity to luminance
    Kernel blur, edge, point;  ///< a Gaussian and its first and second derivative

    Kernels() {
        constexpr double kLuminanceSpread = 0.0047,
                         kWidestSpread = 0.04;  // Table 1; the widest one is blue-yellow's.
        const double pi2 = std::numbers::pi * std::numbers::pi;
        const int contrast_radius_px =
            static_cast<int>(std::ceil(3 * std::sqrt(kWidestSpread / (2 * pi2)) * kPixelsPerDegree));
        contrast = balanced(sampled(contrast_radius_px, [&](double x) {
            const double degrees = x / kPixelsPerDegree;
            return std::exp(-pi2 * degrees * degrees / kLuminanceSpread);
        }));

        const double sigma_px = 0.5 * kFeatureWidth_deg * kPixelsPerDegree;
        const int feature_radius_px = static_cast<int>(std::ceil(3 * sigma_px));
        const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * sigma_px * sigma_px)); };
        blur = balanced(sampled(feature_radius_px, gaussian));
        edge = balanced(sampled(feature_radius_px, [&](double x) { return -x * gaussian(x); }));
        point = balanced(sampled(
            feature_radius_px, [&](double x) { return (x * x / (sigma_px * sigma_px) - 1) * gaussian(x); }));
    }
};

double lightness(double luminance) {
    constexpr double kDelta = 6.0 / 29;
    const double root = luminance > kDelta * kDelta * kDelta ? std::cbrt(luminance)
                                                             : luminance / (3 * kDelta * kDelta) + 4.0 / 29;
    return 116 * root - 16;
}

struct Lab {
    double l, a, b;
};

/// CIELAB of a colour given by its luminance and its X and Z relative to white's, with the Hunt effect:
/// colours fade in the dark.
Lab hunt_adjusted_lab(double relative_x, double y, double relative_z) {
    const double l = lightness(y);
    const double a = 500.0 / 116 * (lightness(relative_x) - l), b = 200.0 / 116 * (l - lightness(relative_z));
    return {l, 0.01 * l * a, 0.01 * l * b};
}

/// The largest colour difference there is, from sRGB's green to its blue, to which all are related.
double largest_color_difference() {
    constexpr double kWhiteX = 0.9504700, kWhiteZ = 1.0888300;
    const Lab green = hunt_adjusted_lab(0.3575761 / kWhiteX, 0.7151522, 0.1191920 / kWhiteZ);
    const Lab blue = hunt_adjusted_lab(0.1804375 / kWhiteX, 0.0721750, 0.9503041 / kWhiteZ);
    const double hyab = std::abs(green.l - blue.l) + std::hypot(green.a - blue.a, green.b - blue.b);
    return std::pow(hyab, kColorExponent);
}

/// In [0,1]: small differences are spread over most of it, the large ones compressed into the rest.
double color_difference(double truth_luminance, double test_luminance) {
    static const double largest = largest_color_difference();
    static const double knee = kColorKnee * largest;
    const double hyab = std::abs(lightness(std::clamp(truth_luminance, 0.0, 1.0)) -
                                 lightness(std::clamp(test_luminance, 0.0, 1.0)));
    const double difference = std::pow(hyab, kColorExponent);
    return difference < knee ? kColorAtKnee / knee * difference
                             : kColorAtKnee + (difference - knee) / (largest - knee) * (1 - kColorAtKnee);
}

struct Rows {
    int first, count;
};

/// Those rows with a margin all around, where the outermost pixels of the image are repeated.
Plane padded(const Plane& image, Rows rows, int margin_x, int margin_y) {
    Plane result(image.width + 2 * margin_x, rows.count + 2 * margin_y);
    for (int y = 0; y < result.height; ++y) {
        const int from_y = std::clamp(rows.first + y - margin_y, 0, image.height - 1);
        const double* from = &image.at(0, from_y);
        double* row = &result.at(0, y);
        std::fill(row, row + margin_x, from[0]);
        std::copy(from, from + image.width, row + margin_x);
        std::fill(row + margin_x + image.width, row + result.width, from[image.width - 1]);
    }
    return result;
}

/// A separable filter over some rows of images that share a mask.
class MaskedFilter {
  public:
    MaskedFilter(const Plane& valid, Rows rows, const Kernel& across, const Kernel& down)
        : rows_(rows), across_(across), down_(down), weight_(convolved(valid)) {}

    /// Mean of the valid pixels, weighted by the kernel: for smoothing kernels. `image` is 0 where it is
    /// invalid.
    Plane mean(const Plane& image) const {
        Plane result = convolved(image);
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (weight_.pixels[i] > 0) result.pixels[i] /= weight_.pixels[i];
        }
        return result;
    }

    /// Response of a kernel whose sum is 0, with the value of the pixel itself in place of every invalid one,
    /// which therefore has no part in it. `image` is 0 where it is invalid.
    Plane derivative(const Plane& image) const {
        Plane result = convolved(image);
        const double* self = &image.at(0, rows_.first);
        for (std::size_t i = 0; i < result.size(); ++i) result.pixels[i] -= self[i] * weight_.pixels[i];
        return result;
    }

  private:
    Plane convolved(const Plane& image) const {
        const int margin_x = static_cast<int>(across_.size() / 2),
                  margin_y = static_cast<int>(down_.size() / 2);
        return convolve_inside(padded(image, rows_, margin_x, margin_y), across_, down_);
    }

    Rows rows_;
    const Kernel& across_;
    const Kernel& down_;
    Plane weight_;
};

/// Much faster than std::hypot, which guards against overflow.
double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// Differences of edges or of points between the two images: of the length of the derivative in x and y.
Plane feature_difference(const Plane& truth, const Plane& test, const Plane& valid, Rows rows,
                         const Kernel& derivative, const Kernel& blur) {
    const MaskedFilter in_x(valid, rows, derivative, blur), in_y(valid, rows, blur, derivative);
    const Plane truth_x = in_x.derivative(truth), truth_y = in_y.derivative(truth);
    const Plane test_x = in_x.derivative(test), test_y = in_y.derivative(test);
    Plane difference(truth.width, rows.count);
    for (std::size_t i = 0; i < difference.size(); ++i) {
        difference.pixels[i] = std::abs(length(truth_x.pixels[i], truth_y.pixels[i]) -
                                        length(test_x.pixels[i], test_y.pixels[i]));
    }
    return difference;
}

/// Sums over the valid pixels of some rows, by block. Images hold luminance, and 0 where they are invalid.
std::vector<double> difference_sums(const Plane& truth, const Plane& test, const Plane& valid, Rows rows,
                                    const BlockGrid& grid) {
    static const Kernels kernels;
    const MaskedFilter contrast(valid, rows, kernels.contrast, kernels.contrast);
    const Plane seen_truth = contrast.mean(truth), seen_test = contrast.mean(test);
    const Plane edges = feature_difference(truth, test, valid, rows, kernels.edge, kernels.blur);
    const Plane points = feature_difference(truth, test, valid, rows, kernels.point, kernels.blur);
    const double* self_valid = &valid.at(0, rows.first);
    const auto difference = [&](std::size_t i) {
        if (self_valid[i] == 0) return 0.0;
        const double color = color_difference(seen_truth.pixels[i], seen_test.pixels[i]);
        const double feature =
            std::pow(std::max(edges.pixels[i], points.pixels[i]) / std::numbers::sqrt2, kFeatureExponent);
        return std::pow(color, 1 - feature);
    };
    std::vector<double> sums(grid.size());
    for (int y = 0; y < rows.count; ++y) {
        grid.for_each_piece(rows.first + y, 0, edges.width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) sums[block] += difference(edges.index(x, y));
        });
    }
    return sums;
}

}  // namespace

MetricValue measure::flip(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    if (!mse) return undefined(kNoValidPixel);
    if (!std::isfinite(*mse)) return undefined(kNotFinite);  // Before infinity is clamped to 1.
    const int width = input.truth.width, height = input.truth.height;
    Plane truth(width, height), test(width, height), valid(width, height);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = valid.index(x, static_cast<int>(y));
            if (input.valid.pixels[i] == 0) continue;  // The values may be NaN there.
            valid.pixels[i] = 1;
            truth.pixels[i] = linear_from_srgb(std::clamp(double{input.truth.pixels[i]}, 0.0, 1.0));
            test.pixels[i] = linear_from_srgb(std::clamp(double{input.test.pixels[i]}, 0.0, 1.0));
        }
    });
    const BlockGrid grid(width, height);
    std::vector<std::vector<double>> bands(band_count(height));
    for_each_band(height, [&](std::size_t band, int first, int rows) {
        bands[band] = difference_sums(truth, test, valid, {first, rows}, grid);
    });
    std::vector<double> sums;
    for (const std::vector<double>& band : bands) add_sums(sums, band);
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    const double count = std::accumulate(valid.pixels.begin(), valid.pixels.end(), 0.0);
    if (input.maps != nullptr) input.maps->flip_sums = std::move(sums);
    return defined(sum / count);
}

}  // namespace aoscore
