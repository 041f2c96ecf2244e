#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/metric.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace aoscore {
namespace {

/// The number of candidates of a row where an image is not finite; marks the others where `finite` is not
/// null.
std::size_t nonfinite_of_row(const ImageF& truth, const ImageF& test, const Mask& candidate, int y,
                             Mask* finite) {
    std::size_t nonfinite = 0;
    const std::size_t first = candidate.index(0, y);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(candidate.width); ++i) {
        const bool wanted = candidate.pixels[i] != 0;
        const bool both = std::isfinite(truth.pixels[i]) && std::isfinite(test.pixels[i]);
        nonfinite += wanted && !both ? 1 : 0;
        if (finite != nullptr) finite->pixels[i] = wanted && both ? 1 : 0;
    }
    return nonfinite;
}

std::size_t nonfinite_of_rows(const ImageF& truth, const ImageF& test, const Mask& candidate, Mask* finite) {
    require_one_size(MetricInput{truth, test, candidate});
    std::vector<std::size_t> rows(static_cast<std::size_t>(candidate.height));
    parallel_for(rows.size(), [&](std::size_t y) {
        rows[y] = nonfinite_of_row(truth, test, candidate, static_cast<int>(y), finite);
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
