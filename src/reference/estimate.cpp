#include "reference/estimate.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

static_assert(1 << kLevels == kBlocks);

/// The weight of the tile's common law against a pixel's own spread, in degrees of freedom. Heavy, so that
/// adaptive tracing cannot stop by a pixel's lucky agreement with itself; likeness in visibility keeps errors
/// within 10 % in tests all the same.
constexpr double kPriorFreedom = 64;

/// Neighbours count the less the more their asin(sqrt(V)), in which binomial noise is even, differs: they are
/// put into bins of this width.
constexpr double kLikeness_rad = 0.1;
constexpr std::size_t kBins = 16;  // pi / 2 of them

/// N^-3/2 of the law: what doubling leaves of the variance.
const double kLawRatio = std::pow(2.0, -1.5);
/// What it mostly leaves in practice, and the weight of this knowledge in degrees of freedom.
constexpr double kUsualRatio = 0.37;
constexpr double kUsualFreedom = 4;
/// Least and most that is believed.
constexpr double kLeastRatio = 0.25, kMostRatio = 0.5;
/// What is left among hairs: the slowest fall seen.
constexpr double kSlowRatio = 0.46;

/// Each level counts so many times what the one below counts for its freedom: less is extrapolated from it.
constexpr double kLevelWeight = 3;

std::size_t bin_of(const PixelSpread& pixel) {
    const double place = std::asin(std::sqrt(pixel.visibility)) / kLikeness_rad;
    return std::min(static_cast<std::size_t>(place), kBins - 1);
}

/// The shape of the variance over visibility and sample count, up to a factor, for one block.
double variance_shape(const PixelSpread& pixel) {
    const double v = pixel.visibility, size = block_size(pixel.samples);
    return std::sqrt(v * (1 - v) + 0.25 / pixel.samples) / (size * std::sqrt(size));
}

/// pooled_variance() of the last count that was asked for: pixels of one tile mostly have the same.
class PooledVariance {
  public:
    double of(int samples, double ratio) {
        if (samples != samples_ || ratio != ratio_) {
            samples_ = samples;
            ratio_ = ratio;
            value_ = pooled_variance(samples, ratio);
        }
        return value_;
    }

  private:
    int samples_ = 0;
    double ratio_ = 0, value_ = 0;
};

double squared(double x) {
    return x * x;
}

/// The pixels of one tile that are mostly open, or those that are mostly blocked.
struct Side {
    int alike = 0;     ///< no more than half of whose rays disagree
    int agreeing = 0;  ///< of these, none of whose rays do
    void count(double disagreeing_part) {
        alike += disagreeing_part <= 0.5;
        agreeing += disagreeing_part == 0;
    }
};

struct Sides {
    Side open, blocked;
};

Sides sides_of(std::span<const PixelSpread> pixels) {
    Sides sides;
    for (const PixelSpread& pixel : pixels) {
        sides.open.count(1 - pixel.visibility);
        sides.blocked.count(pixel.visibility);
    }
    return sides;
}

/// Less than this no pixel states.
double least_error(const PixelSpread& pixel, const Sides& tile) {
    const auto of = [&](const Side& side) {
        return error_of_agreement(pixel.samples, side.agreeing, side.alike);
    };
    if (pixel.visibility == 1) return of(tile.open);
    if (pixel.visibility == 0) return of(tile.blocked);
    return of({1, 1});
}

/// Sums over the pixels of one or several bins.
struct Pool {
    std::array<double, kLevels> freedom{}, differences{}, shapes{};
    void add(const Pool& other, double weight) {
        for (std::size_t l = 0; l < kLevels; ++l) {
            freedom[l] += weight * other.freedom[l];
            differences[l] += weight * other.differences[l];
            shapes[l] += weight * other.shapes[l];
        }
    }
};

/// The common law of one bin: the variance of a block is `scale` times the pixel's shape.
struct Law {
    double scale = 0;
    double ratio = kUsualRatio;
};

Law law_of(const Pool& pool, bool chosen) {
    // Level by level the difference over the shape, if variance fell by kLawRatio.
    std::array<double, kLevels> level{};
    for (std::size_t l = 0; l < kLevels; ++l)
        level[l] = pool.shapes[l] > 0 ? pool.differences[l] / pool.shapes[l] : 0;
    double above = 0, below = 0, freedom = 0, weight = 1;
    for (std::size_t l = 1; l < kLevels; ++l, weight *= kLevelWeight) {
        above += weight * pool.freedom[l] * level[l];
        below += weight * pool.freedom[l] * level[l - 1];
        freedom += weight * pool.freedom[l];
    }
    Law law;
    if (chosen) {
        law.ratio = kSlowRatio;
    } else if (below > 0) {
        const double usual = kUsualFreedom * below / freedom;
        law.ratio = kLawRatio * (above + usual * kUsualRatio / kLawRatio) / (below + usual);
        law.ratio = std::clamp(law.ratio, kLeastRatio, kMostRatio);
    }
    double scale = 0, weights = 0, fall = 1;
    weight = 1;
    for (std::size_t l = 0; l < kLevels; ++l, weight *= kLevelWeight, fall *= kLawRatio / law.ratio) {
        scale += weight * pool.freedom[l] * level[l] * fall;
        weights += weight * pool.freedom[l];
    }
    law.scale = weights > 0 ? scale / weights / (1 - law.ratio) : 0;
    return law;
}

/// The laws of all bins, each from its neighbourhood.
std::array<Law, kBins> laws_of(std::span<const PixelSpread> pixels, bool chosen) {
    std::array<Pool, kBins> own{};
    for (const PixelSpread& pixel : pixels) {
        Pool& pool = own[bin_of(pixel)];
        double shape = variance_shape(pixel);
        for (std::size_t l = 0; l < kLevels; ++l, shape *= kLawRatio) {
            pool.freedom[l] += pixel.pairs[l];
            pool.differences[l] += pixel.pairs[l] * pixel.differences[l];
            pool.shapes[l] += pixel.pairs[l] * shape;
        }
    }
    std::array<Law, kBins> laws;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (own[i].freedom[0] == 0) continue;
        Pool all;
        for (std::size_t j = 0; j < kBins; ++j) {
            const double apart = static_cast<double>(i) - static_cast<double>(j);
            all.add(own[j], 1 / squared(1 + squared(apart)));
        }
        laws[i] = law_of(all, chosen);
    }
    return laws;
}

}  // namespace

PixelSpread pixel_spread(std::span<const double> darkening_sums, int samples) {
    double total = 0;
    for (const double sum : darkening_sums) total += sum;
    PixelSpread pixel;
    pixel.samples = samples;
    pixel.visibility = std::clamp(1 - total / samples, 0.0, 1.0);
    const int size = block_size(samples);
    std::array<double, kBlocks> means{};
    int count = samples / size;  // whole blocks
    for (std::size_t b = 0; b < static_cast<std::size_t>(count); ++b) means[b] = darkening_sums[b] / size;
    for (std::size_t l = 0; l < kLevels; ++l) {
        count /= 2;
        pixel.pairs[l] = count;
        double sum = 0;
        for (std::size_t pair = 0; pair < static_cast<std::size_t>(count); ++pair) {
            sum += squared((means[2 * pair] - means[2 * pair + 1]) / 2);
            means[pair] = (means[2 * pair] + means[2 * pair + 1]) / 2;
        }
        if (count > 0) pixel.differences[l] = sum / count;
    }
    return pixel;
}

double error_of_agreement(int samples, int agreeing, int alike) {
    const double share = static_cast<double>(agreeing) / alike;
    const double stratified = 1 - share, independent = -std::log(share);
    return std::sqrt(stratified * std::sqrt(stratified * independent) + 0.25 / agreeing) / samples;
}

double pooled_variance(int samples, double ratio) {
    const int size = block_size(samples);
    const int whole = samples / size;
    const double rest = static_cast<double>(samples % size) / size;  // of a block
    double sum = whole;
    // A part of a block varies more, by the same law.
    if (rest > 0) sum += squared(rest) * std::pow(rest, std::log2(ratio));
    const int blocks = whole + (rest > 0 ? 1 : 0);
    for (int i = 0; i < blocks; ++i) {
        for (int j = 0; j < i; ++j) {
            double covariance = 2 * ratio - 1;
            for (int shared = 1; (i >> shared) != (j >> shared); ++shared) covariance *= ratio;
            sum += 2 * covariance * (i < whole ? 1 : rest);
        }
    }
    return sum / squared(whole + rest);
}

std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels, bool chosen) {
    const std::array<Law, kBins> laws = laws_of(pixels, chosen);
    const Sides sides = sides_of(pixels);
    std::array<PooledVariance, kBins> pooled;
    std::vector<Estimate> estimates;
    estimates.reserve(pixels.size());
    for (const PixelSpread& pixel : pixels) {
        const int freedom = pixel.freedom();
        if (freedom == 0) {
            estimates.push_back({pixel.visibility, 0.5});
            continue;
        }
        const Law& law = laws[bin_of(pixel)];
        double own = 0, weights = 0, fall = 1 - law.ratio, weight = 1;
        for (std::size_t l = 0; l < kLevels; ++l, fall *= law.ratio, weight *= kLevelWeight) {
            own += weight * pixel.pairs[l] * pixel.differences[l] / fall;
            weights += weight * pixel.pairs[l];
        }
        const double block_variance =
            (kPriorFreedom * law.scale * variance_shape(pixel) + freedom * own / weights) /
            (kPriorFreedom + freedom);
        const double error = std::sqrt(block_variance * pooled[bin_of(pixel)].of(pixel.samples, law.ratio));
        estimates.push_back({pixel.visibility, std::min(std::max(error, least_error(pixel, sides)), 0.5)});
    }
    return estimates;
}

}  // namespace aoscore
