#include "metrics/measures/structural_similarity.h"

#include "metrics/measures/convolution.h"
#include "metrics/measures/wide_lanes.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace aoscore {
namespace {

constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

/// One of the two images: a row of its values, and its moments, computed or looked up.
class Side {
  public:
    explicit Side(const WindowedImage& image)
        : image_(image),
          values_(static_cast<std::size_t>(image.image.width)),
          moving_(image.moments == nullptr ? values_.size() : std::size_t{2 * kSsimBorder_px}) {}

    const std::vector<double>& push(int y, const std::vector<double>& weights) {
        read_counting(image_.image, y, weights, values_);
        if (image_.moments == nullptr) moving_.push(values_, weights);
        return values_;
    }

    /// `y` counts from the first row inside the border.
    MomentRow moments(int y, const double* weight_sums) {
        if (image_.moments == nullptr) return moving_.row(weight_sums);
        return {&image_.moments->mean.at(0, y), &image_.moments->variance.at(0, y)};
    }

  private:
    const WindowedImage& image_;
    std::vector<double> values_;
    MovingMoments moving_;
};

/// The sums of one band of rows. Rows are convolved across as they are read, and down over the last eleven of
/// them, which stay in cache.
class Band {
  public:
    Band(const WindowedImage& truth, const WindowedImage& test, const PixelWeights& weights,
         const BlockGrid& grid, int halvings)
        : truth_(truth),
          test_(test),
          weights_(weights),
          moving_weights_(weights),
          grid_(grid),
          halvings_(halvings),
          products_(static_cast<std::size_t>(weights.width())),
          product_row_(static_cast<std::size_t>(weights.width())),
          ssim_(product_row_.size() - 2 * kSsimBorder_px),
          contrast_structure_(ssim_) {}

    SsimSums sum(int first_row, int rows) {
        SsimSums all(grid_.size());
        for (int y = 0; y < rows + 2 * kSsimBorder_px; ++y) {
            push_row(first_row + y);
            if (y < 2 * kSsimBorder_px) continue;
            const int inner_y = first_row + y - 2 * kSsimBorder_px;
            const double* weight_sums = moving_weights_.sums();
            find_indices(truth_.moments(inner_y, weight_sums), test_.moments(inner_y, weight_sums),
                         products_.sums(), weight_sums);
            add_row(first_row + y - kSsimBorder_px, all);
        }
        return all;
    }

  private:
    void push_row(int y) {
        const std::vector<double>& weights = moving_weights_.push(y);
        const std::vector<double>&truths = truth_.push(y, weights), &tests = test_.push(y, weights);
        for (std::size_t x = 0; x < product_row_.size(); ++x)
            product_row_[x] = weights[x] * (truths[x] * tests[x]);
        products_.push(product_row_.data());
    }

    AOSCORE_WIDER_WHERE_POSSIBLE
    void find_indices(MomentRow truth, MomentRow test, const double* products, const double* weights) {
        double *ssim = ssim_.data(), *contrast_structure = contrast_structure_.data();
        const std::size_t count = ssim_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const double a = truth.mean[i], b = test.mean[i];
            const double covariance = products[i] / weights[i] - a * b;
            const double luminance = (2 * a * b + kC1) / (a * a + b * b + kC1);
            contrast_structure[i] = (2 * covariance + kC2) / (truth.variance[i] + test.variance[i] + kC2);
            ssim[i] = luminance * contrast_structure[i];
        }
    }

    void add_row(int y, SsimSums& all) {
        weights_.read_row(y, product_row_);
        const int last_x = weights_.width() - kSsimBorder_px;
        grid_.for_each_piece(y, kSsimBorder_px, last_x, halvings_, [&](std::size_t block, int from, int to) {
            double ssim = 0, contrast_structure = 0, sum = 0;
            for (int x = from; x < to; ++x) {
                const double weight = product_row_[static_cast<std::size_t>(x)];
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

    Side truth_, test_;
    const PixelWeights& weights_;
    MovingWeights moving_weights_;
    const BlockGrid& grid_;
    int halvings_;
    WindowFilter products_;
    std::vector<double> product_row_, ssim_, contrast_structure_;
};

}  // namespace

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

SsimSums structural_similarity(const WindowedImage& truth, const WindowedImage& test,
                               const PixelWeights& weights, const BlockGrid& grid, int halvings) {
    const int width = weights.width() - 2 * kSsimBorder_px;
    const int height = weights.height() - 2 * kSsimBorder_px;
    SsimSums all(grid.size());
    if (width <= 0 || height <= 0) return all;

    std::vector<SsimSums> bands(band_count(height));
    for_each_band(height, [&](std::size_t band, int first_row, int rows) {
        bands[band] = Band(truth, test, weights, grid, halvings).sum(first_row, rows);
    });
    for (const SsimSums& sums : bands) all.add(sums);
    return all;
}

}  // namespace aoscore
