#include "metrics/intervals/over_scenes.h"

#include <cmath>
#include <random>

namespace aoscore {
namespace {

constexpr int kDrawnSets = 2000;

/// The mean of the squares of the views that `next` gives the places of.
template <class Next>
double mean_square(const std::vector<double>& views, Next next) {
    double sum = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double error = views[next(i)];
        sum += error * error;
    }
    return sum / static_cast<double>(views.size());
}

}  // namespace

double error_over_scenes(const ErrorsByScene& errors) {
    double sum = 0;
    for (const std::vector<double>& views : errors)
        sum += mean_square(views, [](std::size_t i) { return i; });
    return std::sqrt(sum / static_cast<double>(errors.size()));
}

Resampled over_scenes(const ErrorsByScene& errors, std::uint64_t seed) {
    Resampled resampled;
    resampled.value = error_over_scenes(errors);
    std::mt19937_64 random(seed);
    for (int i = 0; i < kDrawnSets; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < errors.size(); ++k) {
            const std::vector<double>& views = errors[random() % errors.size()];
            sum += mean_square(views, [&](std::size_t) { return random() % views.size(); });
        }
        resampled.draws.push_back(std::sqrt(sum / static_cast<double>(errors.size())));
    }
    return resampled;
}

}  // namespace aoscore
