#pragma once

#include <cstdint>

namespace aoscore {

/// Every metric and the analysis on a 1920x1080 pair like visibility, beside SSIM by scikit-image in runs
/// that alternate with ours (where python3-skimage is there), on standard output: the fastest of the runs, so
/// that a busy machine says little.
void bench_compare(std::uint64_t seed);

}  // namespace aoscore
