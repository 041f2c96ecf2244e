#pragma once

#include "core/image.h"
#include "image/pixel_rect.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// How integers in a file stand for visibility.
enum class Coding { linear, srgb };

/// How an image file is to be read as visibility.
struct VisibilityReading {
    std::string channel;           ///< by its name in the file; empty: found, see read_visibility()
    std::optional<Coding> coding;  ///< of integers alone
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
    ImageF standard_error;  ///< SE.Y of Y, SE1.Y of V1.Y; empty without one
    std::string channel;
    std::string why;                    ///< how the channel was found, in words
    std::vector<std::string> warnings;  ///< what makes the channel doubtful
    bool integers = false;              ///< stored as integers, so that the coding mattered
};

/// Reads any image that read_image() reads, and finds the channel as find_visibility() does. Throws their
/// errors, and usage_error for integers whose coding was not said: their values mean two things.
VisibilityFile read_visibility(const std::filesystem::path& path, const VisibilityReading& reading);

/// 1 where a mask of its own is above 0.5 (of integers: of their range); its channel is find_mask()'s.
Mask read_mask(const std::filesystem::path& path, const std::string& channel = {});

}  // namespace aoscore
