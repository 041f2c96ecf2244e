#pragma once

#include "core/image.h"

#include <filesystem>
#include <optional>
#include <string>

namespace aoscore {

/// How integers in a file stand for visibility.
enum class Coding { linear, srgb };

/// How an image file is to be read as visibility.
struct VisibilityReading {
    std::string channel;           ///< by its name in the file; empty: found, see read_visibility()
    std::optional<Coding> coding;  ///< of integers; floats are linear whatever it says
    bool flip = false;             ///< the file's rows run from the bottom up
    bool invert = false;           ///< the file holds occlusion, 1 - visibility
};

/// The visibility that a file holds.
struct VisibilityFile {
    ImageF visibility;
    Mask mask;              ///< 1 where mask.Y is above 0.5, or everywhere without one; alpha is no mask
    ImageF standard_error;  ///< SE.Y; empty without one
    std::string channel;
    bool integers = false;  ///< stored as integers, so that the coding mattered
};

/// Reads any format of OpenImageIO (EXR, PNG, TIFF, HDR, PFM, …). Without a channel's name it takes Y; else
/// the only channel that is no companion; else R of R = G = B; else the only ambient-occlusion layer (AO,
/// <layer>.AO.R); else the only layer whose R, G and B are equal. Companions are alpha, depth, normals,
/// positions, colours and variances by the names that Blender, pbrt, Mitsuba and this program give them.
/// Throws file_error when no channel or more than one qualifies, naming those there are, and usage_error for
/// integers whose coding was not said: their values mean two things.
VisibilityFile read_visibility(const std::filesystem::path& path, const VisibilityReading& reading);

/// 1 where the first channel of an image is above 0.5 (of integers: of their range), for a mask of its own.
Mask read_mask(const std::filesystem::path& path);

}  // namespace aoscore
