#pragma once

#include "metrics/analysis/occlusion_masks.h"
#include "metrics/analysis/pixel_facts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace aoscore {

/// One connected piece (8 neighbours) of a mask of missing or false occlusion.
struct ErrorRegion {
    std::string kind;                              ///< "missing" or "false"
    int left = 0, top = 0, width = 0, height = 0;  ///< its bounding box, pixels
    int worst_x = 0, worst_y = 0;                  ///< the pixel of largest |error|
    double worst_error = 0;                        ///< test - truth there
    std::size_t area_px = 0;
    double mean_error = 0;  ///< mean of test - truth over the region
    std::string cause;      ///< main cause of its true occlusion (PixelFacts::causes); "" if unknown
};

inline constexpr std::size_t kListedRegions = 8;

/// The worst pieces of both masks, by summed error: first the missing, then the false, up to kListedRegions
/// of each.
std::vector<ErrorRegion> worst_regions(const OcclusionMasks& masks, const MetricInput& input,
                                       const std::vector<PixelFacts::Cause>& causes);

}  // namespace aoscore
