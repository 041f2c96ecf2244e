#pragma once

#include "core/environment.h"

#include <filesystem>

namespace aoscore {

/// Reads the light from all around: a picture in equirectangular projection (see EnvironmentMap for its axes)
/// of any size and any format that holds floats, such as Radiance HDR or EXR, with channels R, G and B, or Y
/// alone. It is turned by `turn_deg` counterclockwise about the up axis, seen from above. Throws file_error
/// for another shape than two to one, integers, which end where light begins, pixels that are NaN, infinite
/// or missing, values below 0 that take off more than a thousandth of the light, and a black picture. Smaller
/// ones, which lossy compression leaves, count as 0, and a warning says how many there are.
Environment read_environment(const std::filesystem::path& path, double turn_deg);

}  // namespace aoscore
