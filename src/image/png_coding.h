#pragma once

#include "image/coding.h"

#include <filesystem>
#include <optional>
#include <string>

namespace aoscore {

/// What a file says of the coding of its values.
struct StatedCoding {
    std::optional<Coding> coding;  ///< none where no option reads it
    std::string curve;             ///< in words, such as "linear"
    std::string by;                ///< what says so, such as "chunk gAMA"
};

/// What the chunks of a PNG say: cICP, else an iCCP profile by its name, else sRGB, else gAMA, as decoders
/// are to rank them (W3C, Portable Network Graphics Specification, third edition, 2025), without chunks of a
/// wrong size. Nothing for files of other formats, and where they say nothing or a curve that is not known
/// here.
std::optional<StatedCoding> coding_stated_by_png(const std::filesystem::path& path);

}  // namespace aoscore
