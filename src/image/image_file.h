#pragma once

#include "core/image.h"
#include "image/pixel_rect.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// A named 32-bit float channel of an EXR file.
struct ChannelView {
    std::string name;
    const ImageF* image;
};

/// Writes a scan-line EXR, 32-bit float, ZIP where that saves a third, atomically, with texts. Of
/// EXR's standard attributes, "comments", "capDate" and "owner" are texts; "worldToCamera" and "worldToNDC"
/// become matrices: 16 numbers, row by row, for points that are row vectors (the transposes of ours). Viewers
/// show the layer without a name, so one of the channels should be Y, or three of them R, G, B. Throws
/// file_error when it cannot be written, and internal_error for channels that are empty, of several sizes or
/// of one name.
void write_exr(const std::filesystem::path& path, std::span<const ChannelView> channels,
               const std::map<std::string, std::string>& attributes);

/// An image file with all of its channels by name. Each has the size of the frame, which is EXR's display
/// window and in other formats the picture.
struct ImageFile {
    int width = 0, height = 0;
    std::vector<std::string> channel_names;
    std::vector<ImageF> channels;
    std::vector<PixelRect> covered;     ///< the part of the frame for which each channel has pixels;
                                        ///< the rest is NaN
    std::vector<std::string> left_out;  ///< parts that are deep or of another frame, each with the reason,
                                        ///< and further pages
    std::vector<std::string> doubts;    ///< what its header says of its values that may make them other than
                                        ///< they read, a sentence each
    std::map<std::string, std::string> attributes;
    bool integers = false;  ///< the file holds integers; values are shares of their range

    std::optional<std::size_t> index(const std::string& name) const;
    /// Null when absent.
    const ImageF* channel(const std::string& name) const;
};

/// Reads any format of OpenImageIO (EXR, PNG, PFM, …), and EXR with channels of lower resolution; integers
/// become value/255 or value/65535, colours are not multiplied by alpha, an Orientation is applied, the scale
/// of a PFM too, and the EXPOSURE and COLORCORR of a Radiance file are taken off. Parts of a multi-part EXR
/// are layers with channels named <part>.<channel>; deep parts and those whose frame is not the first one's
/// are left out. Of other files with several pictures the first is read. Pixels of a data window outside of
/// the display window are dropped. Throws file_error for a file that is absent, truncated, no image, larger
/// than 16384 px a side, coded as film density or in XYZE, or has deep parts alone.
ImageFile read_image(const std::filesystem::path& path);

/// Encodes indices into a palette of up to 256 colours (0xRRGGBB) as PNG, with the fewest of 1, 2, 4 or 8
/// bits. Throws internal_error for an index beyond the palette.
std::string encode_png_indexed(const Image<std::uint8_t>& indices,
                               std::span<const std::uint32_t> palette_rgb);
/// Encodes 8-bit gray as PNG.
std::string encode_png_gray(const Image<std::uint8_t>& gray);
/// Encodes red, green and blue of 8 bits as PNG.
std::string encode_png_rgb(const Image<std::array<std::uint8_t, 3>>& colours);

}  // namespace aoscore
