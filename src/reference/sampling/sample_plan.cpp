#include "reference/sampling/sample_plan.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// The least count of the form 2^k or 3 * 2^k, at least 4, that is not below `samples`: scrambled nets are at
/// their best with whole powers of two a set, and two steps an octave waste little.
int round_up(double samples) {
    int count = 4;
    while (count < samples && count < kMostSamples) {
        if (count + count / 2 >= samples) return count + count / 2;
        count *= 2;
    }
    return count;
}

/// Independent rays that the most uncertain pixel, V = 1/2, would need.
double most_uncertain(double error) {
    return 0.25 / (error * error);
}

/// Error falls about as N^-3/4.
constexpr double kSamplesPerError = 4.0 / 3;
/// One round may at most multiply a pixel's rays by this: its error is itself an estimate.
constexpr double kMostGrowth = 4;

}  // namespace

SamplePlan::SamplePlan(const TruthSettings& settings)
    : max_error_(settings.max_error), first_(settings.samples), most_(settings.samples) {
    if (max_error_ <= 0) return;
    first_ = round_up(std::max(static_cast<double>(settings.samples), 2 / max_error_));
    most_ = std::max(first_, round_up(most_uncertain(max_error_)));
}

int SamplePlan::next(int samples, double error) const {
    if (max_error_ <= 0 || error <= max_error_ || samples >= most_) return samples;
    const double wanted = samples * std::min(std::pow(error / max_error_, kSamplesPerError), kMostGrowth);
    return std::min(round_up(std::max(wanted, samples + 1.0)), most_);
}

}  // namespace aoscore
