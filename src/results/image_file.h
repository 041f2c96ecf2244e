#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/image.h"

namespace aoscore {

/// A named 32-bit float channel of an EXR file.
struct ChannelView {
    std::string name;
    const ImageF* image;
};

/// Writes a scan-line EXR, 32-bit float, ZIP, atomically, with text attributes ("aoscore:seed" -> "1"). Channels of
/// one size. Throws file_error.
void write_exr(const std::filesystem::path& path, std::span<const ChannelView> channels,
               const std::map<std::string, std::string>& attributes);

/// An image file with all of its channels by name.
struct ImageFile {
    int width = 0, height = 0;
    std::vector<std::string> channel_names;
    std::vector<ImageF> channels;
    std::map<std::string, std::string> attributes;
    bool eight_bit = false;  ///< stored as integers of 8 or fewer bits

    /// Null when absent.
    const ImageF* channel(const std::string& name) const;
};

/// Reads any format of OpenImageIO (EXR, PNG, PFM, …); integers become value/255 or value/65535.
/// Throws file_error.
ImageFile read_image(const std::filesystem::path& path);

/// The visibility that a file holds, for `compare`: Y, else the only channel, else R where R = G = B, else the
/// documented names of other programs (ViewLayer.AO.R, …). `srgb` undoes sRGB coding of 8-bit files. `mask`
/// receives mask.Y (or alpha-free 1 everywhere). Throws file_error when no channel qualifies, naming those there are.
struct VisibilityFile {
    ImageF visibility;
    Mask mask;
    ImageF standard_error;  ///< empty without SE.Y
    std::string channel;
};
VisibilityFile read_visibility(const std::filesystem::path& path, bool srgb);

/// PNG in memory, 8 bits: indices into a palette of up to 256 RGB colours.
std::string encode_png_indexed(const Image<std::uint8_t>& indices, std::span<const std::uint32_t> palette_rgb);
/// PNG in memory, 8-bit gray.
std::string encode_png_gray(const Image<std::uint8_t>& gray);

}  // namespace aoscore
