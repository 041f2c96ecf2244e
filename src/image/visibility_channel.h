#pragma once

#include "image/image_file.h"

#include <cstddef>
#include <string>

namespace aoscore {

/// The channel of a file that is taken for visibility.
struct VisibilityChannel {
    std::size_t index;    ///< among the file's channels
    std::string why;      ///< in words: "named ambient occlusion"
    std::string warning;  ///< empty, or what makes it doubtful
};

/// Without a name asked for: Y of a truth of this program; else the only layer named as ambient occlusion, as
/// meaning_of() knows it; else the only picture, when it is in grey and the file holds beside it nothing but
/// geometry (depth, normals, masks, …). Depth is never taken, nor a picture of light. A name that was asked
/// for is a channel's, or the end of only one's, or its layer's, in any case. Throws file_error when no
/// channel or more than one qualifies, naming those there are.
VisibilityChannel find_visibility(const ImageFile& file, const std::string& asked, const std::string& where);

/// The channel of a mask: mask.Y or the only layer of its words, else the only picture in grey. Errors as
/// above.
std::size_t find_mask(const ImageFile& file, const std::string& asked, const std::string& where);

}  // namespace aoscore
