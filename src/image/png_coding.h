#pragma once

#include "image/coding.h"

#include <filesystem>
#include <optional>
#include <string>

namespace aoscore {

/// What a file says of the coding of its values.
struct StatedCoding {
    Coding coding;
    std::string by;  ///< what says so, such as "chunk gAMA"
};

/// What the chunks of a PNG say: an iCCP profile by its name, else sRGB, else gAMA, as decoders are to rank
/// them (W3C, Portable Network Graphics Specification, second edition, 2003, 11.3.3). Nothing for files of
/// other formats, and where they say nothing or another curve.
std::optional<StatedCoding> coding_stated_by_png(const std::filesystem::path& path);

}  // namespace aoscore
