#include "metrics/analysis/best_fit.h"

#include "core/threads.h"
#include "metrics/analysis/fit_range.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"
#include "metrics/measures/power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

struct Curve {
    double strength = 1, exponent = 1;

    /// Changes visibilities in place.
    void apply(std::span<double> visibilities) const {
        for (double& value : visibilities) value = std::max(1 - strength * (1 - value), 0.0);
        if (exponent != 1) raise(visibilities, exponent);
        for (double& value : visibilities) value = std::min(value, 1.0);
    }
};

/// The truth's moments by the test's level: the search looks at levels in place of pixels. A level's mean
/// stands for its pixels, which gives the search an error of the order of the level's width squared; reported
/// values are measured on the pixels.
class Levels {
  public:
    explicit Levels(const MetricInput& input) {
        struct Sums {
            double count = 0, test = 0, truth = 0;
        };
        std::array<Sums, kLevels> levels{};
        for (std::size_t i = 0; i < input.truth.size(); ++i) {
            if (input.valid.pixels[i] == 0) continue;
            const double test = std::clamp(double{input.test.pixels[i]}, 0.0, 1.0);
            Sums& level = levels[static_cast<std::size_t>(test * (kLevels - 1) + 0.5)];
            level.count += 1;
            level.test += test;
            level.truth += double{input.truth.pixels[i]};
        }
        for (const Sums& level : levels) {
            if (level.count == 0) continue;
            counts_.push_back(level.count);
            tests_.push_back(level.test / level.count);
            truths_.push_back(level.truth / level.count);
        }
        fitted_ = tests_;
    }

    /// The sum of squared errors less a constant, which is the spread of the truth within levels.
    double badness(const Curve& curve) {
        std::ranges::copy(tests_, fitted_.begin());
        curve.apply(fitted_);
        double sum = 0;
        for (std::size_t i = 0; i < fitted_.size(); ++i) {
            const double error = fitted_[i] - truths_[i];
            sum += counts_[i] * error * error;
        }
        return sum;
    }

  private:
    static constexpr std::size_t kLevels = 1024;
    // Values of the levels that have pixels.
    std::vector<double> counts_, tests_, truths_;
    std::vector<double> fitted_;
};

/// Finds where a function of one variable is least in [low, high]: at the best of a few even steps, then by
/// golden section between its neighbours.
template <class Function>
double least_at(double low, double high, Function function) {
    constexpr int kSteps = 24, kSections = 32;
    const double step = (high - low) / kSteps;
    double best = low, least = function(low);
    for (int i = 1; i <= kSteps; ++i) {
        const double x = low + i * step, value = function(x);
        if (value >= least) continue;
        least = value;
        best = x;
    }
    double a = std::max(best - step, low), b = std::min(best + step, high);
    double c = b - (b - a) / std::numbers::phi, d = a + (b - a) / std::numbers::phi;
    double at_c = function(c), at_d = function(d);
    for (int i = 0; i < kSections; ++i) {
        if (at_c < at_d) {
            b = d;
            d = c;
            at_d = at_c;
            c = b - (b - a) / std::numbers::phi;
            at_c = function(c);
        } else {
            a = c;
            c = d;
            at_c = at_d;
            d = a + (b - a) / std::numbers::phi;
            at_d = function(d);
        }
    }
    const double middle = (a + b) / 2;
    return function(middle) < least ? middle : best;
}

/// Strength and exponent almost compensate each other, in a narrow curved valley: the search therefore finds
/// the best strength for every exponent that it tries.
Curve search(Levels& levels) {
    const auto best_strength = [&](double exponent) {
        return least_at(kFitStrengths.least, kFitStrengths.most, [&](double strength) {
            return levels.badness({strength, exponent});
        });
    };
    const double least_log2 = std::log2(kFitExponents.least), most_log2 = std::log2(kFitExponents.most);
    const double exponent = std::exp2(least_at(least_log2, most_log2, [&](double log2_exponent) {
        const double tried = std::exp2(log2_exponent);
        return levels.badness({best_strength(tried), tried});
    }));
    return {best_strength(exponent), exponent};
}

/// Mean squared error and mean error of the image after the curve, rounded as an image is.
struct FittedError {
    double squared = 0, signed_sum = 0, count = 0;
    std::vector<double> squared_by_block;  ///< of the blocks of one row, or of all
    double mse() const { return squared / count; }
    double bias() const { return signed_sum / count; }
};

FittedError error_of_row(const MetricInput& input, const Curve& curve, const BlockGrid& grid, int y) {
    const std::size_t first = input.valid.index(0, y), width = static_cast<std::size_t>(input.valid.width);
    std::vector<double> values(width);
    for (std::size_t x = 0; x < width; ++x)
        values[x] = input.valid.pixels[first + x] != 0 ? double{input.test.pixels[first + x]} : 0.0;
    curve.apply(values);
    FittedError sum;
    sum.squared_by_block.resize(static_cast<std::size_t>(grid.across));
    for (std::size_t x = 0; x < width; ++x) {
        if (input.valid.pixels[first + x] == 0) continue;
        const double error = double{static_cast<float>(values[x])} - double{input.truth.pixels[first + x]};
        sum.squared += error * error;
        sum.squared_by_block[x / static_cast<std::size_t>(grid.side_px)] += error * error;
        sum.signed_sum += error;
        ++sum.count;
    }
    return sum;
}

FittedError fitted_error(const MetricInput& input, const Curve& curve) {
    const BlockGrid grid(input.valid.width, input.valid.height);
    std::vector<FittedError> rows(static_cast<std::size_t>(input.valid.height));
    parallel_for(rows.size(),
                 [&](std::size_t y) { rows[y] = error_of_row(input, curve, grid, static_cast<int>(y)); });
    FittedError all;
    all.squared_by_block.resize(grid.size());
    for (std::size_t y = 0; y < rows.size(); ++y) {
        const FittedError& row = rows[y];
        all.squared += row.squared;
        all.signed_sum += row.signed_sum;
        all.count += row.count;
        const std::size_t first = y / static_cast<std::size_t>(grid.side_px) * row.squared_by_block.size();
        for (std::size_t i = 0; i < row.squared_by_block.size(); ++i)
            all.squared_by_block[first + i] += row.squared_by_block[i];
    }
    return all;
}

}  // namespace

std::optional<BestFit> best_fit(const MetricInput& input) {
    const std::optional<double> as_it_is = mean_squared_error(input);
    if (!as_it_is || !std::isfinite(*as_it_is)) return std::nullopt;
    Levels levels(input);
    Curve curve = search(levels);
    FittedError error = fitted_error(input, curve);
    if (error.mse() > *as_it_is) {  // The levels misled the search: nothing is gained.
        curve = {};
        error = fitted_error(input, curve);
    }
    BestFit fit{curve.strength, curve.exponent, std::sqrt(error.mse()), {}, error.bias(), {}};
    fit.squared_sums = std::move(error.squared_by_block);
    if (knows_noise(input)) {
        const double variance = *mean_noise_variance(input);
        if (std::isfinite(variance)) fit.rmse_debiased = std::sqrt(std::max(error.mse() - variance, 0.0));
    }
    return fit;
}

}  // namespace aoscore
