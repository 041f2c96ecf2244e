#pragma once

#include "image/image_file.h"

#include <cstddef>
#include <string>

namespace aoscore {

/// The channel of a file that is taken for visibility.
struct VisibilityChannel {
    std::size_t index;    ///< its place among the file's channels
    std::string why;      ///< the reason in words: "named ambient occlusion"
    std::string warning;  ///< the reason for doubt; empty without one
};

/// Finds visibility. Where no name is asked for, it is Y of a truth of this program; else the only layer that
/// meaning_of() takes for occlusion; else the only picture, when it is grey and the file holds nothing else
/// but geometry (depth, normals, masks, …). Depth is never taken, nor a picture of light. A name asked for is
/// that of a channel or its layer, or the end of only one such name, in any case. Throws file_error when no
/// channel or more than one qualifies, naming those there are.
VisibilityChannel find_visibility(const ImageFile& file, const std::string& asked, const std::string& where);

/// Finds the channel of a mask: mask.Y or the only layer whose name says mask, else the only picture in grey.
/// Throws the same errors.
std::size_t find_mask(const ImageFile& file, const std::string& asked, const std::string& where);

}  // namespace aoscore
