#pragma once

#include "core/ratio_table.h"
#include "reference/truth.h"

#include <cmath>
#include <vector>

namespace aoscore {

struct ReferenceBenchmark {
    int width = 1920;
    int height = 1080;
    double target_error = 0.004;  ///< mean standard error to reach
    std::vector<double> radii_m = {1.0, INFINITY};
    int tiles = 192;         ///< random tiles whose rays are recorded and replayed
    int samples = 256;       ///< rays a pixel of those
    double longest_s = 120;  ///< truths that take longer are measured on random tiles only, and scaled up
    bool growth = true;      ///< also measure over pixels and triangles
};

/// Measures the reference on a view and prints tables to standard output: error over samples against
/// independent samples; million rays a second against bare replays of the very same rays from memory; time to
/// the target error against plain Monte Carlo with rtcOccluded1, and whether the stated error is the true
/// one; time over pixels and over triangles. All ratios in one run; the baselines run on the stated random
/// subset of tiles. Replays get their rays for free, plain Monte Carlo makes its own. Rates and times are
/// left in `table`, too: traced rays beside the replay of the very same packets by bare Embree, times beside
/// those of plain Monte Carlo to the same error.
void reference_benchmark(const Scene& scene, const View& view, const ReferenceBenchmark& benchmark,
                         RatioTable& table);

}  // namespace aoscore
