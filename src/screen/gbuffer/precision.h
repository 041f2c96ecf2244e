#pragma once

#include "screen/screen.h"

#include <string_view>
#include <vector>

namespace aoscore {

/// A format of depth and normals: a row of the one table.
struct PrecisionFormat {
    Precision precision;
    std::string_view id;       ///< its name on the command line and in results: "depth-24"
    std::string_view stored;   ///< STORED of shaders/gbuffer/stored_depth.frag; empty: depth as it was drawn
    std::string_view normals;  ///< STORED of shaders/gbuffer/stored_normal.frag; empty: as they were drawn
    std::string_view meaning;
    /// Positions are stored in place of depth: three floats that methods need not compute.
    bool positions = false;
};
const std::vector<PrecisionFormat>& precision_formats();

const PrecisionFormat& format_of(Precision precision);

}  // namespace aoscore
