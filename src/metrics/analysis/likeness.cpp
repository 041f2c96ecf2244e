#include "metrics/analysis/likeness.h"

#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace aoscore {
namespace {

// Values of about a half are subtracted, so that flat pictures keep their digits.
constexpr double kMiddle = 0.5;

/// Reads a row less kMiddle, 0 where a pixel does not count or is not finite in both images; `counts` is 1 or
/// 0.
AOSCORE_WIDER_WHERE_POSSIBLE
void read_centred(std::span<const float> truth, std::span<const float> test,
                  std::span<const std::uint8_t> valid, double* a, double* b, double* counts) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const float of_both = (truth[i] - truth[i]) + (test[i] - test[i]);  // not 0 for NaN and infinity
        const bool counting = valid[i] != 0 && of_both == 0;
        a[i] = counting ? double{truth[i]} - kMiddle : 0.0;
        b[i] = counting ? double{test[i]} - kMiddle : 0.0;
        counts[i] = counting ? 1.0 : 0.0;
    }
}

AOSCORE_WIDER_WHERE_POSSIBLE
double sum_of_products(const double* a, const double* b, std::size_t count) {
    Lanes sums{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes x, y;
        load(x, a + i);
        load(y, b + i);
        sums += x * y;
    }
    double sum = sum_of(sums);
    for (; i < count; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

void LikenessSums::add(std::span<const float> truth, std::span<const float> test,
                       std::span<const std::uint8_t> valid) {
    const std::size_t count = truth.size();
    std::vector<double> a(count), b(count), counts(count);
    read_centred(truth, test, valid, a.data(), b.data(), counts.data());
    count_ += sum_of_products(counts.data(), counts.data(), count);
    truth_ += sum_of_products(a.data(), counts.data(), count);
    test_ += sum_of_products(b.data(), counts.data(), count);
    truth_squared_ += sum_of_products(a.data(), a.data(), count);
    test_squared_ += sum_of_products(b.data(), b.data(), count);
    product_ += sum_of_products(a.data(), b.data(), count);
}

void LikenessSums::add(const LikenessSums& other) {
    count_ += other.count_;
    truth_ += other.truth_;
    test_ += other.test_;
    truth_squared_ += other.truth_squared_;
    test_squared_ += other.test_squared_;
    product_ += other.product_;
}

std::optional<Likeness> LikenessSums::likeness() const {
    if (count_ < 2) return std::nullopt;
    const double of_truth = truth_squared_ - truth_ * truth_ / count_;
    const double of_test = test_squared_ - test_ * test_ / count_;
    // Rounding gives constant pictures less than this.
    const double least = 1e-12 * count_;
    if (!(of_truth > least) || !(of_test > least)) return std::nullopt;
    const double both = product_ - truth_ * test_ / count_;
    return Likeness{both / std::sqrt(of_truth * of_test),
                    std::sqrt(std::max(truth_squared_ + test_squared_ - 2 * product_, 0.0) / count_)};
}

}  // namespace aoscore
