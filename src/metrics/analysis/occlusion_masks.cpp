#include "metrics/analysis/occlusion_masks.h"

#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aoscore {

namespace {

/// The error that a mask needs at each pixel of a row.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_limits(const float* standard_error, double threshold, double* limits, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        limits[i] = std::max(threshold, kMaskStandardErrors * double{standard_error[i]});
}

AOSCORE_WIDER_WHERE_POSSIBLE
void mark(const float* truth, const float* test, const std::uint8_t* valid, const double* limits,
          std::uint8_t* missing, std::uint8_t* false_occlusion, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double difference = double{test[i]} - double{truth[i]};
        const bool brighter = difference > limits[i], darker = difference < -limits[i];
        missing[i] = static_cast<std::uint8_t>(brighter & (valid[i] != 0));
        false_occlusion[i] = static_cast<std::uint8_t>(darker & (valid[i] != 0));
    }
}

void mark_row(const MetricInput& input, double threshold, int y, OcclusionMasks& masks) {
    const auto width = static_cast<std::size_t>(input.valid.width);
    std::vector<double> limits(width, threshold);
    if (input.standard_error != nullptr)
        find_limits(&input.standard_error->at(0, y), threshold, limits.data(), width);
    mark(&input.truth.at(0, y), &input.test.at(0, y), &input.valid.at(0, y), limits.data(),
         &masks.missing.at(0, y), &masks.false_occlusion.at(0, y), width);
}

}  // namespace

OcclusionMasks occlusion_masks(const MetricInput& input, double threshold) {
    require_one_size(input);
    OcclusionMasks masks{Mask(input.truth.width, input.truth.height),
                         Mask(input.truth.width, input.truth.height)};
    parallel_for(static_cast<std::size_t>(input.truth.height),
                 [&](std::size_t y) { mark_row(input, threshold, static_cast<int>(y), masks); });
    return masks;
}

}  // namespace aoscore
