#include "metrics/measures/structural_similarity.h"

#include "core/threads.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// The indices of a row of pixels.
struct IndexRow {
    explicit IndexRow(std::size_t width) : ssim(width), contrast_structure(width), noisy_ssim(width) {}
    std::vector<double> ssim, contrast_structure, noisy_ssim;
};

AOSCORE_WIDER_WHERE_POSSIBLE
void find_products(const double* truth, const double* test, const double* weights, double* products,
                   std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) products[i] = weights[i] * (truth[i] * test[i]);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void find_indices(MomentRow truth, MomentRow test, const double* products, const double* scales, double* ssim,
                  double* contrast_structure, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double a = truth.mean[i], b = test.mean[i];
        const double covariance = products[i] * scales[i] - a * b;
        const double luminance = 2 * a * b + kSsimC1, most_luminance = a * a + b * b + kSsimC1;
        const double structure = 2 * covariance + kSsimC2;
        const double most_structure = truth.variance[i] + test.variance[i] + kSsimC2;
        const double both = 1 / (most_luminance * most_structure);
        ssim[i] = luminance * structure * both;
        contrast_structure[i] = structure * most_luminance * both;
    }
}

/// The index by another variance of the truth, which is but in the denominator of its structure.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_noisy_indices(const double* ssim, const double* variance, const double* noisy_variance,
                        const double* test_variance, double* noisy_ssim, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        noisy_ssim[i] = ssim[i] * ((variance[i] + test_variance[i] + kSsimC2) /
                                   (noisy_variance[i] + test_variance[i] + kSsimC2));
    }
}

struct PieceSums {
    double ssim = 0, contrast_structure = 0, weights = 0;
};

/// The weighted sums over a piece of a row. Where the weight is 0 the indices may be NaN.
AOSCORE_WIDER_WHERE_POSSIBLE
PieceSums sums_of_piece(const double* weights, const double* ssim, const double* contrast_structure,
                        std::size_t count) {
    Lanes ssims{}, structures{}, all_weights{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes weight, s, c;
        load(weight, weights + i);
        load(s, ssim + i);
        load(c, contrast_structure + i);
        const auto counts = weight != 0;
        ssims += counts ? weight * s : Lanes{};
        structures += counts ? weight * c : Lanes{};
        all_weights += weight;
    }
    PieceSums sums{sum_of(ssims), sum_of(structures), sum_of(all_weights)};
    for (; i < count; ++i) {
        if (weights[i] == 0) continue;
        sums.ssim += weights[i] * ssim[i];
        sums.contrast_structure += weights[i] * contrast_structure[i];
        sums.weights += weights[i];
    }
    return sums;
}

/// The same of one index.
AOSCORE_WIDER_WHERE_POSSIBLE
double sum_of_piece(const double* weights, const double* index, std::size_t count) {
    Lanes sums{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes weight, each;
        load(weight, weights + i);
        load(each, index + i);
        sums += weight != 0 ? weight * each : Lanes{};
    }
    double sum = sum_of(sums);
    for (; i < count; ++i) sum += weights[i] == 0 ? 0 : weights[i] * index[i];
    return sum;
}

/// One of the two images: a row of its values, and its moments, computed or looked up.
class Side {
  public:
    Side(const WindowedImage& image, const ImageArea& area)
        : image_(image),
          left_(area.left),
          values_(static_cast<std::size_t>(area.width + 2 * kSsimBorder_px)),
          moving_(image.moments == nullptr ? values_.size() : std::size_t{2 * kSsimBorder_px}) {}

    const std::vector<double>& push(int y, const std::vector<double>& weights) {
        read_counting(image_.image, left_, y, weights, values_);
        if (image_.moments == nullptr) moving_.push(values_, weights);
        return values_;
    }

    /// Of two rows from `y` on, which counts from the first row inside the border.
    MomentRows moments(int y, const RowPair& scales) {
        if (image_.moments == nullptr) return moving_.rows(scales);
        return {stored(y), stored(std::min(y + 1, image_.moments->mean.height - 1))};
    }

    bool has_noisy_variance() const { return image_.noisy_variance != nullptr; }
    /// Of the row `y`, counted like that of the moments.
    const double* noisy_variance(int y) const { return &image_.noisy_variance->at(left_, y); }

  private:
    MomentRow stored(int y) const {
        return {&image_.moments->mean.at(left_, y), &image_.moments->variance.at(left_, y)};
    }

    const WindowedImage& image_;
    int left_;
    std::vector<double> values_;
    MovingMoments moving_;
};

/// The sums of one area, by each of several grids. Rows are convolved across as they are read, and down over
/// the last eleven of them, which stay in cache.
class AreaSums {
  public:
    AreaSums(const WindowedImage& truth, const WindowedImage& test, const PixelWeights& weights,
             const ImageArea& area, std::span<const BlockGrid> grids, int halvings)
        : area_(area),
          truth_(truth, area),
          test_(test, area),
          weights_(weights),
          moving_weights_(weights, area),
          grids_(grids),
          halvings_(halvings),
          product_row_(static_cast<std::size_t>(area.width + 2 * kSsimBorder_px)),
          products_(product_row_.size()),
          indices_(static_cast<std::size_t>(area.width)) {
        for (const BlockGrid& grid : grids) sums_.emplace_back(grid.size(), truth_.has_noisy_variance());
    }

    std::vector<SsimSums> sums() {
        for_each_pair(
            area_, [this](int y) { push_row(y); }, [this](int y) { add_pair(y); });
        return std::move(sums_);
    }

  private:
    void push_row(int y) {
        const std::vector<double>& weights = moving_weights_.push(y);
        const std::vector<double>&truths = truth_.push(y, weights), &tests = test_.push(y, weights);
        find_products(truths.data(), tests.data(), weights.data(), product_row_.data(), product_row_.size());
        products_.push(product_row_.data());
    }

    /// Adds the indices of two rows, or of the area's last one.
    void add_pair(int y) {
        const RowPair scales = moving_weights_.scales(), products = products_.sums();
        const MomentRows truth = truth_.moments(y, scales), test = test_.moments(y, scales);
        for (int i = 0; i < std::min(2, area_.top + area_.height - y); ++i) {
            const auto row = static_cast<std::size_t>(i);
            find_indices(truth[row], test[row], products[row], scales[row], indices_.ssim.data(),
                         indices_.contrast_structure.data(), indices_.ssim.size());
            if (truth_.has_noisy_variance())
                find_noisy_indices(indices_.ssim.data(), truth[row].variance, truth_.noisy_variance(y + i),
                                   test[row].variance, indices_.noisy_ssim.data(), indices_.ssim.size());
            add_row(y + i + kSsimBorder_px);
        }
    }

    /// Adds the indices of row `y` of the image.
    void add_row(int y) {
        const int left = area_.left + kSsimBorder_px;
        const std::span<double> weights = std::span(product_row_).first(indices_.ssim.size());
        weights_.read_row(left, y, weights);
        for (std::size_t g = 0; g < grids_.size(); ++g) {
            grids_[g].for_each_piece(
                y, left, left + area_.width, halvings_, [&](std::size_t block, int from, int to) {
                    const auto first = static_cast<std::size_t>(from - left);
                    const auto count = static_cast<std::size_t>(to - from);
                    const PieceSums piece = sums_of_piece(&weights[first], &indices_.ssim[first],
                                                          &indices_.contrast_structure[first], count);
                    sums_[g].ssim[block] += piece.ssim;
                    sums_[g].contrast_structure[block] += piece.contrast_structure;
                    sums_[g].weights[block] += piece.weights;
                    if (truth_.has_noisy_variance())
                        sums_[g].noisy_ssim[block] +=
                            sum_of_piece(&weights[first], &indices_.noisy_ssim[first], count);
                });
        }
    }

    const ImageArea& area_;
    Side truth_, test_;
    const PixelWeights& weights_;
    MovingWeights moving_weights_;
    std::span<const BlockGrid> grids_;
    int halvings_;
    std::vector<double> product_row_;
    WindowFilter products_;
    IndexRow indices_;
    std::vector<SsimSums> sums_;
};

}  // namespace

void SsimSums::add(const SsimSums& other) {
    add_sums(ssim, other.ssim);
    add_sums(contrast_structure, other.contrast_structure);
    add_sums(weights, other.weights);
    add_sums(noisy_ssim, other.noisy_ssim);
}

std::optional<SsimMeans> SsimSums::means() const {
    const auto total = [](const std::vector<double>& sums) {
        return std::accumulate(sums.begin(), sums.end(), 0.0);
    };
    const double weight = total(weights);
    if (weight == 0) return std::nullopt;
    return SsimMeans{total(ssim) / weight, total(contrast_structure) / weight};
}

std::vector<SsimSums> structural_similarity(const WindowedImage& truth, const WindowedImage& test,
                                            const PixelWeights& weights, std::span<const BlockGrid> grids,
                                            int halvings) {
    std::vector<SsimSums> all;
    for (const BlockGrid& grid : grids) all.emplace_back(grid.size(), truth.noisy_variance != nullptr);
    if (std::min(weights.width(), weights.height()) <= 2 * kSsimBorder_px) return all;

    const std::vector<ImageArea> areas = windowed_areas(weights.width(), weights.height());
    std::vector<std::vector<SsimSums>> of_areas(areas.size());
    parallel_for(areas.size(), [&](std::size_t i) {
        of_areas[i] = AreaSums(truth, test, weights, areas[i], grids, halvings).sums();
    });
    for (const std::vector<SsimSums>& sums : of_areas) {
        for (std::size_t g = 0; g < all.size(); ++g) all[g].add(sums[g]);
    }
    return all;
}

}  // namespace aoscore
