#pragma once

#include "core/image.h"

#include <cstdint>
#include <string>

namespace aoscore {

/// These functions pack one of the surfaces behind one another of a view, exactly, as zlib streams in
/// dense_text(); reports/page/scripts/live_surfaces.js unpacks them.

/// Packs triangles' numbers. Each pixel has a byte: 0 to 3 where the number is that of the pixel to the left,
/// above, above to the right, above to the left (the first of these), and 4 where it is none of them. Then
/// come the numbers of the last kind, minus the one above (in the first row the one to the left, in the first
/// pixel 0), folded and in planes as in folded_planes().
std::string pack_triangles(const Image<std::uint32_t>& triangles);

/// Packs positive depths, whose triangles are unpacked before them: the bits of each float minus those of a
/// prediction, as folded_planes(). On a triangle the reciprocal of depth is linear across the picture, so
/// that three pixels of the same triangle tell it; kPlanes lists which ones are tried.
std::string pack_depths(const ImageF& depth_m, const Image<std::uint32_t>& triangles);

}  // namespace aoscore
