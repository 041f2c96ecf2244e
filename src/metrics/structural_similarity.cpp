#include "metrics/structural_similarity.h"

#include "metrics/convolution.h"

#include <array>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

constexpr int kWindow_px = 2 * kSsimBorder_px + 1;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

std::array<double, kWindow_px> gaussian_window() {
    std::array<double, kWindow_px> window{};
    double sum = 0;
    for (int i = 0; i < kWindow_px; ++i) {
        const double distance = (i - kSsimBorder_px) / 1.5;
        sum += window[static_cast<std::size_t>(i)] = std::exp(-0.5 * distance * distance);
    }
    for (double& value : window) value /= sum;
    return window;
}

/// Weighted sums under the window: of the weight, of both images, of their squares and of their product.
struct Moments {
    Plane weight, truth, test, truth_truth, test_test, truth_test;

    Moments(int width, int height)
        : weight(width, height),
          truth(weight),
          test(weight),
          truth_truth(weight),
          test_test(weight),
          truth_test(weight) {}
};

Moments window_moments(const WeightedPair& pair, int first_row, int rows) {
    Moments sums(pair.truth.width, rows + 2 * kSsimBorder_px);
    for (std::size_t i = 0; i < sums.weight.size(); ++i) {
        const std::size_t from = pair.truth.index(0, first_row) + i;
        const double weight = pair.weight.pixels[from];
        if (weight == 0) continue;  // The values may be NaN there.
        const double truth = pair.truth.pixels[from], test = pair.test.pixels[from];
        sums.weight.pixels[i] = weight;
        sums.truth.pixels[i] = weight * truth;
        sums.test.pixels[i] = weight * test;
        sums.truth_truth.pixels[i] = weight * truth * truth;
        sums.test_test.pixels[i] = weight * test * test;
        sums.truth_test.pixels[i] = weight * truth * test;
    }
    static const std::array<double, kWindow_px> window = gaussian_window();
    for (Plane Moments::*plane : {&Moments::weight, &Moments::truth, &Moments::test, &Moments::truth_truth,
                                  &Moments::test_test, &Moments::truth_test}) {
        sums.*plane = convolve_inside(sums.*plane, window, window);
    }
    return sums;
}

SsimMeans index_at(const Moments& sums, std::size_t i) {
    const double weight = sums.weight.pixels[i];
    const double truth = sums.truth.pixels[i] / weight, test = sums.test.pixels[i] / weight;
    const double truth_variance = sums.truth_truth.pixels[i] / weight - truth * truth;
    const double test_variance = sums.test_test.pixels[i] / weight - test * test;
    const double covariance = sums.truth_test.pixels[i] / weight - truth * test;
    const double luminance = (2 * truth * test + kC1) / (truth * truth + test * test + kC1);
    const double contrast_structure = (2 * covariance + kC2) / (truth_variance + test_variance + kC2);
    return {luminance * contrast_structure, contrast_structure};
}

}  // namespace

WeightedPair weighted_pair(const MetricInput& input) {
    WeightedPair pair{input.truth, input.test, ImageF(input.valid.width, input.valid.height)};
    for (std::size_t i = 0; i < pair.weight.size(); ++i) {
        pair.weight.pixels[i] = input.valid.pixels[i] != 0 ? 1.0F : 0.0F;
    }
    return pair;
}

std::optional<SsimMeans> structural_similarity(const WeightedPair& pair) {
    const int width = pair.truth.width - 2 * kSsimBorder_px;
    const int height = pair.truth.height - 2 * kSsimBorder_px;
    if (width <= 0 || height <= 0) return std::nullopt;

    struct Sums {
        SsimMeans weighted;
        double weight = 0;
    };
    std::vector<Sums> bands(band_count(height));
    for_each_band(height, [&](std::size_t band, int first_row, int rows) {
        const Moments moments = window_moments(pair, first_row, rows);
        Sums sums;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < width; ++x) {
                const double weight = pair.weight.at(x + kSsimBorder_px, first_row + y + kSsimBorder_px);
                if (weight == 0) continue;
                const SsimMeans index = index_at(moments, moments.weight.index(x, y));
                sums.weighted.ssim += weight * index.ssim;
                sums.weighted.contrast_structure += weight * index.contrast_structure;
                sums.weight += weight;
            }
        }
        bands[band] = sums;
    });

    Sums all;
    for (const Sums& sums : bands) {
        all.weighted.ssim += sums.weighted.ssim;
        all.weighted.contrast_structure += sums.weighted.contrast_structure;
        all.weight += sums.weight;
    }
    if (all.weight == 0) return std::nullopt;
    return SsimMeans{all.weighted.ssim / all.weight, all.weighted.contrast_structure / all.weight};
}

}  // namespace aoscore
