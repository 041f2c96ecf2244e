#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// A colour as 0xRRGGBB, sRGB.
using Rgb = std::uint32_t;

/// A colour map by a few control points at equal distances, interpolated between them in sRGB.
using ColourMap = std::span<const Rgb>;

/// Magnitudes: black over purple and orange to pale yellow. After magma (van der Walt, Smith, 2015).
ColourMap magma();
/// Depth: dark blue over green to yellow. After viridis (van der Walt, Smith, 2015).
ColourMap viridis();
/// Signed error: blue over near-white to red, of equal lightness at both ends. After RdBu (Brewer, 2003).
ColourMap blue_red();
/// Visibility without colour.
ColourMap gray();

/// The map at `position` in [0,1].
Rgb colour_at(ColourMap map, double position);
/// `steps` (at least 2) colours from end to end.
std::vector<Rgb> palette(ColourMap map, int steps);

/// "#rrggbb".
std::string css_colour(Rgb colour);
/// "linear-gradient(to right,…)" over the map's control points.
std::string css_gradient(ColourMap map);

/// Colours of the masks: told apart under every common colour blindness, and from gray. After Okabe, Ito,
/// Color Universal Design, 2008.
inline constexpr Rgb kMissingOcclusionColour = 0xd55e00;
inline constexpr Rgb kFalseOcclusionColour = 0x0072b2;
/// Pixels without a valid comparison.
inline constexpr Rgb kInvalidColour = 0x6f6f76;
/// Pixels that hold no finite number.
inline constexpr Rgb kNonfiniteColour = 0xff00ff;

}  // namespace aoscore
