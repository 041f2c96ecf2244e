#pragma once

#include "core/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace aoscore {

/// These functions pack numbers for the page's live methods. Each result is a zlib stream (RFC 1950) in
/// dense_text(); reports/page/scripts/live_decode.js unpacks it.

std::string pack_text(std::string_view text);

/// An image of numbers or directions, and how its stream is read.
struct PackedInput {
    std::string kind;  ///< "floats", "normals" or "predicted normals"
    std::string data;
};

/// Four planes of bytes, the highest ones of all residuals first, which are folded so that 0, -1, 1, -2, …
/// become 0, 1, 2, 3, …
std::string folded_planes(std::span<const std::uint32_t> residuals);

/// Packs integers row by row, exactly: the residuals after left + up - upper left (0 outside) modulo 2^32, as
/// folded_planes(). The bits of positive floats order as the floats do, so that this packs depth as well, at
/// about 5 bits a pixel.
std::string pack_integers(std::span<const std::uint32_t> values, int width);
PackedInput pack_floats(const ImageF& image);

/// Packs unit vectors in octahedral codes of 16 bits a component (Meyer, Süßmuth, Sußner, Stamminger,
/// Greiner, On Floating-Point Normal Vectors, 2010): the error is at most 7e-5 rad, and the axes are exact.
/// "normals" are the codes of each pixel, which is short for flat triangles; "predicted normals" are the
/// residuals of all first codes and then of all second ones (median_residuals.h), which is short for curved
/// surfaces. The shorter one is taken.
PackedInput pack_normals(const Image<glm::vec3>& normals);

}  // namespace aoscore
