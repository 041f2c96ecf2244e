#pragma once

#include "core/ratio_table.h"

#include <cstdint>

namespace aoscore {

/// Processor milliseconds of every metric and the analysis on a 1920x1080 pair like visibility, each beside
/// one plain pass over both images that adds squared differences; of a score against a truth with halves,
/// beside the same with the truth prepared; of SSIM by scikit-image (where python3-skimage is there), in runs
/// that alternate with ours. The fastest of several runs, so that a busy machine says little.
void bench_compare(std::uint64_t seed, RatioTable& table);

/// Processor seconds and peak memory of `aoscore compare` as a whole process on a pair of EXR files of
/// 3840x2160, beside those of OpenImageIO's `idiff` (where it is installed).
void bench_compare_files(std::uint64_t seed, RatioTable& table);

}  // namespace aoscore
