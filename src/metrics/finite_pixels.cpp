#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"
#include "metrics/metric.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace aoscore {
namespace {

/// 1 for NaN and infinity, else 0; a comparison would keep the compiler from taking several values at once.
[[gnu::always_inline]] inline std::uint32_t is_nonfinite(float value) {
    constexpr std::uint32_t kSign = 0x80000000, kInfinite = 0x7f800000;
    return ((std::bit_cast<std::uint32_t>(value) & ~kSign) + (kSign - kInfinite)) >> 31;
}

/// The number of candidates of a row where an image is not finite; marks the others where `finite` is not
/// null.
template <bool kMark>
[[gnu::always_inline]] inline std::uint32_t nonfinite_of_row(const float* truth, const float* test,
                                                             const std::uint8_t* candidate,
                                                             std::uint8_t* finite, std::size_t count) {
    std::uint32_t nonfinite = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t wanted = candidate[i] != 0 ? 1 : 0;
        const std::uint32_t lost = wanted & (is_nonfinite(truth[i]) | is_nonfinite(test[i]));
        nonfinite += lost;
        if (kMark) finite[i] = static_cast<std::uint8_t>(wanted - lost);
    }
    return nonfinite;
}

AOSCORE_WIDER_WHERE_POSSIBLE
std::uint32_t count_nonfinite(const float* truth, const float* test, const std::uint8_t* candidate,
                              std::size_t count) {
    return nonfinite_of_row<false>(truth, test, candidate, nullptr, count);
}

AOSCORE_WIDER_WHERE_POSSIBLE
std::uint32_t mark_finite(const float* truth, const float* test, const std::uint8_t* candidate,
                          std::uint8_t* finite, std::size_t count) {
    return nonfinite_of_row<true>(truth, test, candidate, finite, count);
}

std::size_t nonfinite_of_rows(const ImageF& truth, const ImageF& test, const Mask& candidate, Mask* finite) {
    require_one_size(MetricInput{truth, test, candidate});
    std::vector<std::size_t> rows(static_cast<std::size_t>(candidate.height));
    const auto width = static_cast<std::size_t>(candidate.width);
    parallel_for(rows.size(), [&](std::size_t y) {
        const std::size_t first = y * width;
        const float *of_truth = truth.pixels.data() + first, *of_test = test.pixels.data() + first;
        const std::uint8_t* wanted = candidate.pixels.data() + first;
        rows[y] = finite != nullptr
                      ? mark_finite(of_truth, of_test, wanted, finite->pixels.data() + first, width)
                      : count_nonfinite(of_truth, of_test, wanted, width);
    });
    return std::accumulate(rows.begin(), rows.end(), std::size_t{0});
}

}  // namespace

Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite) {
    Mask finite(truth.width, truth.height);
    nonfinite = nonfinite_of_rows(truth, test, candidate, &finite);
    return finite;
}

std::size_t nonfinite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate) {
    return nonfinite_of_rows(truth, test, candidate, nullptr);
}

}  // namespace aoscore
