#include "metrics/analysis/best_fit.h"

#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace aoscore {
namespace {

constexpr double kMostStrength = 4, kMostExponent = 8;

struct Curve {
    double strength = 1, exponent = 1;

    double operator()(double visibility) const {
        const double base = std::max(1 - strength * (1 - visibility), 0.0);
        return std::min(exponent == 1 ? base : std::pow(base, exponent), 1.0);
    }
};

/// The truth's moments by the test's level: the search looks at levels in place of pixels. A level's mean
/// stands for its pixels, so that an error of the order of the level's width squared is left to the search
/// alone; what is reported is measured on the pixels.
class Levels {
  public:
    explicit Levels(const MetricInput& input) {
        for (std::size_t i = 0; i < input.truth.size(); ++i) {
            if (input.valid.pixels[i] == 0) continue;
            const double test = std::clamp(double{input.test.pixels[i]}, 0.0, 1.0);
            Level& level = levels_[static_cast<std::size_t>(test * (kLevels - 1) + 0.5)];
            level.count += 1;
            level.test += test;
            level.truth += double{input.truth.pixels[i]};
        }
        for (Level& level : levels_) {
            if (level.count == 0) continue;
            level.test /= level.count;
            level.truth /= level.count;
        }
    }

    /// Sum of squared errors but for a constant: the spread of the truth within levels.
    double badness(const Curve& curve) const {
        double sum = 0;
        for (const Level& level : levels_) {
            if (level.count == 0) continue;
            const double error = curve(level.test) - level.truth;
            sum += level.count * error * error;
        }
        return sum;
    }

  private:
    static constexpr std::size_t kLevels = 1024;
    struct Level {
        double count = 0, test = 0, truth = 0;
    };
    std::array<Level, kLevels> levels_{};
};

/// Where a function of one variable is least in [low, high]: the best of a few even steps, then by golden
/// section between its neighbours.
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

/// Strength and exponent make up for each other nearly, in a narrow curved valley: hence the best strength
/// for every exponent that is tried.
Curve search(const Levels& levels) {
    const auto best_strength = [&](double exponent) {
        return least_at(0, kMostStrength, [&](double strength) {
            return levels.badness({strength, exponent});
        });
    };
    const double most_log2 = std::log2(kMostExponent);
    const double exponent = std::exp2(least_at(-most_log2, most_log2, [&](double log2_exponent) {
        const double tried = std::exp2(log2_exponent);
        return levels.badness({best_strength(tried), tried});
    }));
    return {best_strength(exponent), exponent};
}

ImageF fitted(const ImageF& test, const Mask& valid, const Curve& curve) {
    ImageF result(test.width, test.height);
    parallel_for(static_cast<std::size_t>(test.height), [&](std::size_t y) {
        const std::size_t first = y * static_cast<std::size_t>(test.width);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(test.width); ++i) {
            if (valid.pixels[i] != 0) result.pixels[i] = static_cast<float>(curve(double{test.pixels[i]}));
        }
    });
    return result;
}

}  // namespace

std::optional<BestFit> best_fit(const MetricInput& input) {
    const std::optional<double> as_it_is = mean_squared_error(input);
    if (!as_it_is || !std::isfinite(*as_it_is)) return std::nullopt;
    Curve curve = search(Levels(input));
    ImageF image = fitted(input.test, input.valid, curve);
    double mse = *mean_squared_error({input.truth, image, input.valid});
    if (mse > *as_it_is) {  // Off by the search's levels: there is nothing to gain.
        curve = {};
        image = fitted(input.test, input.valid, curve);
        mse = *mean_squared_error({input.truth, image, input.valid});
    }
    BestFit fit{curve.strength, curve.exponent, std::sqrt(mse), {}, 0};
    fit.bias = *mean_over_valid({input.truth, image, input.valid}, [](double error) { return error; });
    if (knows_noise(input)) {
        const double variance = *mean_noise_variance(input);
        if (std::isfinite(variance)) fit.rmse_debiased = std::sqrt(std::max(mse - variance, 0.0));
    }
    return fit;
}

}  // namespace aoscore
