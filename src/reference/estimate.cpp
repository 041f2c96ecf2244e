#include "reference/estimate.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

Estimate pooled_estimate(std::span<const double> darkening_sums, int samples) {
    double total = 0;
    for (const double sum : darkening_sums) total += sum;
    const double mean = total / samples;
    Estimate estimate;
    estimate.visibility = std::clamp(1 - mean, 0.0, 1.0);

    const int sets = std::min(static_cast<int>(darkening_sums.size()), samples);
    if (sets < 2) {
        estimate.standard_error = 0.5;
        return estimate;
    }
    double spread = 0;
    for (int set = 0; set < sets; ++set) {
        const int size = samples / sets + (set < samples % sets ? 1 : 0);
        const double deviation = darkening_sums[static_cast<std::size_t>(set)] / size - mean;
        spread += size * deviation * deviation;
    }
    const double variance = spread / (static_cast<double>(sets - 1) * samples);
    estimate.standard_error = std::max(std::sqrt(variance), standard_error_floor(samples));
    return estimate;
}

}  // namespace aoscore
