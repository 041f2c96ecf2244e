#pragma once

#include "metrics/metric.h"

#include <optional>

namespace aoscore {

/// The correlation of a test image with the truth, which ignores brightness and contrast.
struct Likeness {
    double correlation = 0;  ///< Pearson's, from -1 to 1
    double rmse = 0;

    /// The share of the truth's variance that no multiple of the test plus a constant explains; all of it
    /// where the correlation is negative.
    double unexplained() const { return correlation < 0 ? 1 : 1 - correlation * correlation; }
};

/// Computes it over the valid pixels that are finite in both; empty where fewer than two are, or where either
/// image is constant. Throws sizes_differ.
std::optional<Likeness> likeness(const MetricInput& input);

}  // namespace aoscore
