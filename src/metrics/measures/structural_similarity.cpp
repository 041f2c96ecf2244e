#include "metrics/measures/structural_similarity.h"

#include "metrics/measures/convolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace aoscore {
namespace {

constexpr int kWindow_px = 2 * kSsimBorder_px + 1;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

/// The middle of the window's row and what lies right of it.
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

/// Sums under the window. That of the weight comes last: where all pixels weigh alike it is 1 and left out.
enum Moment : std::size_t { kTruth, kTest, kSquares, kProduct, kWeight, kMoments };

struct WeightedImages {
    const ImageF &truth, &test, &weight;
};

/// The sums of one band of rows. Rows are convolved across as they are read, and down over the last eleven of
/// them, which stay in cache.
class Band {
  public:
    Band(const WeightedImages& pair, bool weighted, const BlockGrid& grid, int halvings)
        : pair_(pair),
          grid_(grid),
          halvings_(halvings),
          moments_(weighted ? kMoments : kWeight),
          width_(static_cast<std::size_t>(pair.truth.width)),
          inner_(width_ - 2 * kSsimBorder_px),
          terms_(moments_ * width_),
          ring_(moments_ * kWindow_px * inner_),
          sums_(kMoments * inner_, 1.0),
          ssim_(inner_),
          contrast_structure_(inner_) {}

    SsimSums sum(int first_row, int rows) {
        SsimSums all(grid_.size());
        for (int y = 0; y < rows + 2 * kSsimBorder_px; ++y) {
            read_row(first_row + y);
            convolve_across(static_cast<std::size_t>(y));
            if (y < 2 * kSsimBorder_px) continue;
            convolve_down(static_cast<std::size_t>(y));
            find_indices();
            add_row(first_row + y - kSsimBorder_px, all);
        }
        return all;
    }

  private:
    void read_row(int y) {
        const std::size_t from = pair_.truth.index(0, y);
        double *truths = &terms_[kTruth * width_], *tests = &terms_[kTest * width_];
        double *squares = &terms_[kSquares * width_], *products = &terms_[kProduct * width_];
        for (std::size_t x = 0; x < width_; ++x) {
            double truth = pair_.truth.pixels[from + x], test = pair_.test.pixels[from + x];
            if (moments_ > kWeight) {
                const double weight = pair_.weight.pixels[from + x];
                if (weight == 0) truth = test = 0;  // The values may be NaN there.
                terms_[kWeight * width_ + x] = weight;
                squares[x] = weight * (truth * truth + test * test);
                products[x] = weight * (truth * test);
                truths[x] = weight * truth;
                tests[x] = weight * test;
            } else {
                squares[x] = truth * truth + test * test;
                products[x] = truth * test;
                truths[x] = truth;
                tests[x] = test;
            }
        }
    }

    double* ring_row(std::size_t moment, std::size_t y) {
        return &ring_[(moment * kWindow_px + y % kWindow_px) * inner_];
    }

    void convolve_across(std::size_t y) {
        std::array<const double*, kWindow_px> from{};
        for (std::size_t m = 0; m < moments_; ++m) {
            for (std::size_t k = 0; k < kWindow_px; ++k) from[k] = &terms_[m * width_ + k];
            even_sums(ring_row(m, y), from, kHalfWindow, inner_);
        }
    }

    void convolve_down(std::size_t y) {
        std::array<const double*, kWindow_px> from{};
        for (std::size_t m = 0; m < moments_; ++m) {
            for (std::size_t k = 0; k < kWindow_px; ++k) from[k] = ring_row(m, y - 2 * kSsimBorder_px + k);
            even_sums(&sums_[m * inner_], from, kHalfWindow, inner_);
        }
    }

    AOSCORE_WIDER_WHERE_POSSIBLE void find_indices() {
        const double* sums = sums_.data();
        const std::size_t n = inner_;
        double *ssim = ssim_.data(), *contrast_structure = contrast_structure_.data();
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = sums[kWeight * n + i];
            const double truth = sums[kTruth * n + i] / weight, test = sums[kTest * n + i] / weight;
            const double means_squared = truth * truth + test * test;
            const double variances = sums[kSquares * n + i] / weight - means_squared;
            const double covariance = sums[kProduct * n + i] / weight - truth * test;
            const double luminance = (2 * truth * test + kC1) / (means_squared + kC1);
            contrast_structure[i] = (2 * covariance + kC2) / (variances + kC2);
            ssim[i] = luminance * contrast_structure[i];
        }
    }

    void add_row(int y, SsimSums& all) const {
        const float* weights = &pair_.weight.at(0, y);
        const int last_x = pair_.weight.width - kSsimBorder_px;
        grid_.for_each_piece(y, kSsimBorder_px, last_x, halvings_, [&](std::size_t block, int from, int to) {
            double ssim = 0, contrast_structure = 0, sum = 0;
            for (int x = from; x < to; ++x) {
                const double weight = weights[x];
                if (weight == 0) continue;
                const auto i = static_cast<std::size_t>(x - kSsimBorder_px);
                ssim += weight * ssim_[i];
                contrast_structure += weight * contrast_structure_[i];
                sum += weight;
            }
            all.ssim[block] += ssim;
            all.contrast_structure[block] += contrast_structure;
            all.weights[block] += sum;
        });
    }

    inline static const std::array<double, kSsimBorder_px + 1> kHalfWindow = half_gaussian_window();
    const WeightedImages& pair_;
    const BlockGrid& grid_;
    int halvings_;
    std::size_t moments_, width_, inner_;
    std::vector<double> terms_;  ///< one row of what is summed, by moment
    std::vector<double> ring_;   ///< eleven rows convolved across, by moment
    std::vector<double>
        sums_;  ///< one row under the window, by moment; the weight stays 1 where it is left out
    std::vector<double> ssim_, contrast_structure_;
};

}  // namespace

ImageF weights_of(const Mask& valid) {
    ImageF weight(valid.width, valid.height);
    for (std::size_t i = 0; i < valid.size(); ++i) weight.pixels[i] = valid.pixels[i] != 0 ? 1.0F : 0.0F;
    return weight;
}

void SsimSums::add(const SsimSums& other) {
    add_sums(ssim, other.ssim);
    add_sums(contrast_structure, other.contrast_structure);
    add_sums(weights, other.weights);
}

std::optional<SsimMeans> SsimSums::means() const {
    const auto total = [](const std::vector<double>& sums) {
        return std::accumulate(sums.begin(), sums.end(), 0.0);
    };
    const double weight = total(weights);
    if (weight == 0) return std::nullopt;
    return SsimMeans{total(ssim) / weight, total(contrast_structure) / weight};
}

SsimSums structural_similarity(const ImageF& truth, const ImageF& test, const ImageF& weight,
                               const BlockGrid& grid, int halvings) {
    const WeightedImages pair{truth, test, weight};
    const int width = pair.truth.width - 2 * kSsimBorder_px;
    const int height = pair.truth.height - 2 * kSsimBorder_px;
    SsimSums all(grid.size());
    if (width <= 0 || height <= 0) return all;

    const bool weighted = std::ranges::any_of(pair.weight.pixels, [](float w) { return w != 1; });
    std::vector<SsimSums> bands(band_count(height));
    for_each_band(height, [&](std::size_t band, int first_row, int rows) {
        bands[band] = Band(pair, weighted, grid, halvings).sum(first_row, rows);
    });
    for (const SsimSums& sums : bands) all.add(sums);
    return all;
}

}  // namespace aoscore
