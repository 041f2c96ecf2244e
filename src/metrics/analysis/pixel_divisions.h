#pragma once

#include "core/image.h"
#include "metrics/analysis/pixel_facts.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The valid pixels divided by one property of theirs.
struct PixelDivision {
    std::string_view id, label, unit, meaning;  ///< as Split has them
    std::vector<std::string> bins;              ///< labels
    /// Each pixel's bin; as many as there are bins where it is not valid.
    Image<std::uint8_t> bin_of;
};

/// By distance from a depth edge, tilt and view depth, where they are known, and by distance from the image's
/// border. None of it depends on what is compared, so that all tests of a view can share it.
std::vector<PixelDivision> pixel_divisions(const Mask& valid, const PixelFacts& facts);

}  // namespace aoscore
