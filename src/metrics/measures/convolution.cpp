#include "metrics/measures/convolution.h"

#include "core/threads.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

namespace aoscore {
namespace {

// The height of a band: large enough that rows read twice by neighbours cost little, small enough for its
// planes to stay in cache.
constexpr int kBandRows = 64;

// The number of doubles side by side. They are written out, because GCC 12 would vectorise over the taps
// instead.
constexpr std::size_t kLanes = 8;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

enum class Symmetry { even, odd };

/// Adds a weight times the values at `after`, and the same (or its negative) for `before`.
template <Symmetry kSymmetry, class Value>
[[gnu::always_inline]] inline void add_pair(Value& sum, double weight, const double* after,
                                            const double* before) {
    Value v, w;
    std::memcpy(&v, after, sizeof v);
    std::memcpy(&w, before, sizeof w);
    sum += weight * (kSymmetry == Symmetry::even ? v + w : v - w);
}

template <Symmetry kSymmetry, class Value>
[[gnu::always_inline]] inline void begin_with_middle(Value& sum, double weight, const double* middle) {
    if (kSymmetry == Symmetry::odd) return;
    Value v;
    std::memcpy(&v, middle, sizeof v);
    sum = weight * v;
}

template <Symmetry kSymmetry>
[[gnu::always_inline]] inline void symmetric_sums(double* sums, std::span<const double* const> from,
                                                  std::span<const double> half, std::size_t count) {
    assert(from.size() + 1 == 2 * half.size());
    constexpr std::size_t kBlock = 4 * kLanes;  // the number of sums that stay in registers
    const double* const* middle = &from[half.size() - 1];
    std::size_t i = 0;
    for (; i + kBlock <= count; i += kBlock) {
        Lanes a{}, b{}, c{}, d{};
        begin_with_middle<kSymmetry>(a, half[0], middle[0] + i);
        begin_with_middle<kSymmetry>(b, half[0], middle[0] + i + kLanes);
        begin_with_middle<kSymmetry>(c, half[0], middle[0] + i + 2 * kLanes);
        begin_with_middle<kSymmetry>(d, half[0], middle[0] + i + 3 * kLanes);
        for (std::size_t k = 1; k < half.size(); ++k) {
            const double weight = half[k];
            const double *after = middle[k] + i, *before = *(middle - k) + i;
            add_pair<kSymmetry>(a, weight, after, before);
            add_pair<kSymmetry>(b, weight, after + kLanes, before + kLanes);
            add_pair<kSymmetry>(c, weight, after + 2 * kLanes, before + 2 * kLanes);
            add_pair<kSymmetry>(d, weight, after + 3 * kLanes, before + 3 * kLanes);
        }
        std::memcpy(sums + i, &a, sizeof a);
        std::memcpy(sums + i + kLanes, &b, sizeof b);
        std::memcpy(sums + i + 2 * kLanes, &c, sizeof c);
        std::memcpy(sums + i + 3 * kLanes, &d, sizeof d);
    }
    for (; i < count; ++i) {
        double sum = 0;
        begin_with_middle<kSymmetry>(sum, half[0], middle[0] + i);
        for (std::size_t k = 1; k < half.size(); ++k)
            add_pair<kSymmetry>(sum, half[k], middle[k] + i, *(middle - k) + i);
        sums[i] = sum;
    }
}

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void even_sums(double* sums, std::span<const double* const> from, std::span<const double> half,
               std::size_t count) {
    symmetric_sums<Symmetry::even>(sums, from, half, count);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void odd_sums(double* sums, std::span<const double* const> from, std::span<const double> half,
              std::size_t count) {
    symmetric_sums<Symmetry::odd>(sums, from, half, count);
}

std::size_t band_count(int height) {
    return static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
}

void for_each_band(int height, const std::function<void(std::size_t, int, int)>& body) {
    parallel_for(band_count(height), [&](std::size_t band) {
        const int first = static_cast<int>(band) * kBandRows;
        body(band, first, std::min(kBandRows, height - first));
    });
}

}  // namespace aoscore
