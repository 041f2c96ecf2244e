#pragma once

#include "metrics/measures/finest_similarity.h"
#include "metrics/measures/mean_error.h"

#include <optional>

namespace aoscore {

/// What several metrics of one pair have in common: the first of them leaves it for the others.
struct SharedSums {
    std::optional<DifferenceSums> differences;
    std::optional<FinestSimilarity> finest;
};

}  // namespace aoscore
