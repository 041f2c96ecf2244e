#pragma once

#include "core/image.h"
#include "image/coding.h"
#include "image/pixel_rect.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Options for reading an image file as visibility.
struct VisibilityReading {
    std::string channel;           ///< its name in the file; empty: read_visibility() finds it
    std::optional<Coding> coding;  ///< how integers are coded; floats ignore it
    bool srgb_floats = false;      ///< floats are sRGB-coded too
    bool flip = false;             ///< the file's rows run from the bottom up
    bool mirror = false;           ///< the file's columns run from the right to the left
    bool invert = false;           ///< the file holds occlusion, 1 - visibility
};

/// The visibility that a file holds.
struct VisibilityFile {
    ImageF visibility;
    Mask
        mask;  ///< 1 where the file has a pixel, and mask.Y, where it has one, is above 0.5; alpha is no mask
    PixelRect covered;      ///< the part of the picture that the file has pixels for
    ImageF standard_error;  ///< channel SE.Y for Y, SE1.Y for V1.Y; empty without one
    std::string channel;
    std::string why;                    ///< how the channel was found, in words
    std::vector<std::string> warnings;  ///< reasons to doubt the channel, or its coding
    bool integers = false;              ///< stored as integers, so that the coding mattered
};

/// Reads any image that read_image() reads, and finds the channel as find_visibility() does. Throws their
/// errors, and usage_error for integers whose coding was not said: their values mean two things.
VisibilityFile read_visibility(const std::filesystem::path& path, const VisibilityReading& reading);

/// Reads a mask from a file: 1 where the channel that find_mask() finds is above 0.5 (integers as shares of
/// their range).
Mask read_mask(const std::filesystem::path& path, const std::string& channel = {});

}  // namespace aoscore
