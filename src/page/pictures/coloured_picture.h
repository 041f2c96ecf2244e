#pragma once

#include "core/image.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace aoscore {

/// Colours from the low to the high end (0xRRGGBB), followed by magenta for NaN.
using Palette = std::vector<std::uint32_t>;

/// The colour of pixels that are not compared, in place of magenta.
inline constexpr std::uint32_t kNotComparedColour = 0x6f6f76;

/// `steps` colours, at most 255, evenly along the anchors (red, green, blue, 0 to 255). An odd number gives
/// the middle a colour of its own.
Palette palette_between(const std::vector<std::array<double, 3>>& anchors, int steps);

/// A palette from black to white.
Palette gray_palette(int steps);
/// A palette from blue over white to red for signed errors, red where the picture is too bright.
Palette blue_red_palette(int steps);
/// A palette from black over violet and orange to pale yellow for magnitudes (magma; van der Walt, Smith,
/// 2015).
Palette magma_palette(int steps);

/// Encodes pictures of one size below each other as a PNG data URI: `low` has the first colour, `high` the
/// last.
std::string coloured_picture(const std::vector<const ImageF*>& images, double low, double high,
                             const Palette& palette);

}  // namespace aoscore
