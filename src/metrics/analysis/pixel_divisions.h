#pragma once

#include "core/image.h"
#include "metrics/analysis/pixel_facts.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The valid pixels divided by one of their properties.
struct PixelDivision {
    std::string_view id, label, unit, meaning;  ///< as in Split
    std::vector<std::string> bins;              ///< labels
    /// Each pixel's bin; the number of bins where it is not valid.
    Image<std::uint8_t> bin_of;
};

/// Divides by distance from a depth edge, tilt and view depth, where they are known, and by distance from the
/// image's border. Divisions do not depend on the test image, so that all tests of a view can share them.
std::vector<PixelDivision> pixel_divisions(const Mask& valid, const PixelFacts& facts);

}  // namespace aoscore
