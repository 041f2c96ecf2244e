#pragma once

#include "screen/screen.h"

#include <string_view>
#include <vector>

namespace aoscore {

/// A format of depth and normals: a row of the one table.
struct PrecisionFormat {
    Precision precision;
    std::string_view id;      ///< its name on the command line and in results: "depth-24"
    std::string_view stored;  ///< STORED of shaders/gbuffer/stored_depth.frag; empty: depth as it was drawn
    bool packs_normals = false;
    std::string_view meaning;
};
const std::vector<PrecisionFormat>& precision_formats();

const PrecisionFormat& format_of(Precision precision);

}  // namespace aoscore
