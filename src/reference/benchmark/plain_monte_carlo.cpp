#include "reference/benchmark/plain_monte_carlo.h"

#include <cmath>
#include <numeric>

namespace aoscore {

PlainMonteCarlo::PlainMonteCarlo(const Truth& truth) {
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        const double v = truth.visibility[0].pixels[i];
        if (truth.hits.surface.pixels[i] != 0) deviations_.push_back(std::sqrt(v * (1 - v)));
    }
}

double PlainMonteCarlo::samples_for(double error) const {
    const double sum = std::accumulate(deviations_.begin(), deviations_.end(), 0.0);
    return std::pow(sum / static_cast<double>(deviations_.size()) / error, 2);
}

double PlainMonteCarlo::best_samples_for(double error) const {
    double sum = 0;
    for (const double d : deviations_) sum += std::cbrt(d * d);
    return std::pow(sum / static_cast<double>(deviations_.size()), 3) / (error * error);
}

}  // namespace aoscore
