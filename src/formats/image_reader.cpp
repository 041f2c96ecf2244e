#include "core/error.h"
#include "formats/image_strips.h"
#include "formats/readers.h"
#include "formats/stated_values.h"
#include "image/exr_header.h"
#include "image/image_file.h"
#include "image/image_frame.h"
#include "image/image_limits.h"
#include "image/radiance_header.h"
#include "image/subsampled_exr.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <new>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// Refuses an EXR whose header claims more values than the file's bytes can hold, in its picture or in one of
/// its tiles: memory would be filled for pixels that are not there. `bytes` is the file's size.
void require_plausible_exr(const OIIO::ImageSpec& spec, std::uintmax_t bytes, const std::string& where) {
    const bool dwa = std::string_view(spec.get_string_attribute("compression")).starts_with("dwa");
    const double most = static_cast<double>(bytes) * (dwa ? kMostValuesAByteOfDwa : kMostValuesAByte);
    const double picture = 1.0 * spec.width * spec.height * spec.nchannels;
    const double tile = 1.0 * spec.tile_width * spec.tile_height * spec.tile_depth * spec.nchannels;
    if (std::max(picture, tile) <= most) return;
    const bool by_tile = tile > picture;
    throw file_error(
        fmt::format("claims {} of {}x{} pixels, more than {} bytes can hold", by_tile ? "tiles" : "a picture",
                    by_tile ? spec.tile_width : spec.width, by_tile ? spec.tile_height : spec.height, bytes),
        where, "a whole EXR file");
}

/// One part of a file: its frame, and the place of its pixels in that. Only EXR has frames of their own
/// (display windows); elsewhere the pixels are the frame.
struct Part {
    int frame_width, frame_height;
    PixelRect pixels;

    Part(const OIIO::ImageSpec& spec, bool exr)
        : frame_width(exr ? spec.full_width : spec.width),
          frame_height(exr ? spec.full_height : spec.height),
          pixels{exr ? offset(spec.x, spec.full_x) : 0, exr ? offset(spec.y, spec.full_y) : 0, spec.width,
                 spec.height} {}

    /// Limits the distance that a header claims: beyond the width of any picture it makes no difference.
    static int offset(int begin, int frame_begin) {
        constexpr std::int64_t kFar = 4 * kLargestImageSide_px;
        return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{begin} - frame_begin, -kFar, kFar));
    }
    bool fills_frame() const { return pixels == PixelRect{0, 0, frame_width, frame_height}; }
};

void require_readable(const OIIO::ImageSpec& spec, const Part& part, const std::string& where) {
    if (spec.depth > 1) throw file_error("is a volume", where, "an image");
    require_allocatable(spec.width, spec.height, spec.nchannels, where);
    require_allocatable(part.frame_width, part.frame_height, spec.nchannels, where);
    if (!within_frame(part.pixels, part.frame_width, part.frame_height).empty()) return;
    throw file_error(fmt::format("holds {}x{} pixels at {}, {} of a frame of {}x{}", spec.width, spec.height,
                                 part.pixels.x, part.pixels.y, part.frame_width, part.frame_height),
                     where, "at least a pixel of the frame");
}

/// Reads one part. Where a file has several, channels carry the part's name: "<part>.<channel>".
void read_part(OIIO::ImageInput& input, int subimage, const Part& part, const std::string& name,
               const std::string& where, ImageFile& file) {
    const std::size_t before = file.channels.size();
    read_strips(input, subimage, where, file.channels);
    const PixelRect covered = within_frame(part.pixels, part.frame_width, part.frame_height);
    for (std::size_t c = before; c < file.channels.size(); ++c) {
        file.covered.push_back(covered);
        if (part.fills_frame()) continue;
        ImageF& image = file.channels[c];
        image = placed(image, part.pixels.x, part.pixels.y, part.frame_width, part.frame_height);
    }
    for (const std::string& channel : input.spec(subimage).channelnames) {
        const bool bare = name.empty() || channel.starts_with(name + ".");
        file.channel_names.push_back(bare ? channel : name + "." + channel);
    }
}

/// EXR's standard attributes that OpenImageIO renames.
const std::map<std::string, std::string, std::less<>> kExrNames = {
    {"Copyright", "owner"}, {"DateTime", "capDate"}, {"ImageDescription", "comments"}};

std::map<std::string, std::string> attributes_of(const OIIO::ImageSpec& spec, bool exr) {
    std::map<std::string, std::string> attributes;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        std::string name(attribute.name());
        if (const auto renamed = kExrNames.find(name); exr && renamed != kExrNames.end())
            name = renamed->second;
        if (attribute.type() == OIIO::TypeMatrix44) {
            const std::span numbers(static_cast<const float*>(attribute.data()), 16);
            attributes[name] = fmt::format("{}", fmt::join(numbers, " "));
        } else {
            attributes[name] = attribute.get_string();
        }
    }
    return attributes;
}

/// Gives the values of a Radiance picture before it was exposed and corrected.
void take_off_factors(const RadianceHeader& header, ImageFile& file) {
    for (std::size_t c = 0; c < std::min(header.factors.size(), file.channels.size()); ++c) {
        if (header.factors[c] == 1) continue;
        for (float& value : file.channels[c].pixels) value /= header.factors[c];
    }
}

void refuse_xyze(const fs::path& path) {
    if (read_radiance_header(path).format != "32-bit_rle_xyze") return;
    throw file_error("is coded in CIE colours (XYZE)", path.string(),
                     "a Radiance picture of FORMAT=32-bit_rle_rgbe");
}

void turn_upright(ImageFile& file, const Orientation& orientation) {
    for (ImageF& image : file.channels) image = shown(image, orientation);
    for (PixelRect& covered : file.covered) covered = shown(covered, file.width, file.height, orientation);
    if (orientation.transposed) std::swap(file.width, file.height);
}

/// Whether there are pictures beside the first, which a format without layers by name does not tell apart.
/// The first of a PSD is all of its layers.
bool has_further_pages(OIIO::ImageInput& input) {
    const std::string_view format = input.format_name();
    return format != "openexr" && format != "psd" && input.seek_subimage(1, 0);
}

/// Reads all parts, into which other programs put layers. The first flat part decides the frame.
ImageFile read_all_parts(OIIO::ImageInput& input, const fs::path& path) {
    const std::string where = path.string();
    const std::uintmax_t bytes = fs::file_size(path);
    const bool exr = std::string_view(input.format_name()) == "openexr";
    const bool several = exr && input.seek_subimage(1, 0);
    ImageFile file;
    if (has_further_pages(input)) file.left_out.emplace_back("the file's further pages");
    for (int subimage = 0; subimage == 0 || (several && input.seek_subimage(subimage, 0)); ++subimage) {
        input.seek_subimage(subimage, 0);
        const OIIO::ImageSpec spec = input.spec(subimage);
        const Part part(spec, exr);
        const std::string name(several ? spec.get_string_attribute("oiio:subimagename") : "");
        const bool first = file.channels.empty();
        const bool of_frame = part.frame_width == file.width && part.frame_height == file.height;
        if (spec.deep || (!first && !of_frame)) {
            file.left_out.push_back(fmt::format(
                "{} ({})", name.empty() ? fmt::format("part {}", subimage) : name,
                spec.deep ? "deep" : fmt::format("{}x{} pixels", part.frame_width, part.frame_height)));
            continue;
        }
        require_readable(spec, part, where);
        refuse_film(spec, where);
        if (exr) require_plausible_exr(spec, bytes, where);
        if (first) {
            file.width = part.frame_width;
            file.height = part.frame_height;
            file.integers = !spec.format.is_floating_point();
            file.attributes = attributes_of(spec, exr);
            refuse_factors_of_none(input, path);
            file.doubts = doubts_of(input, spec, path);
        }
        read_part(input, subimage, part, name, where, file);
    }
    if (file.channels.empty()) throw file_error("is a deep image", where, "a flat one");
    if (std::string_view(input.format_name()) == "hdr") take_off_factors(read_radiance_header(path), file);
    const Orientation orientation = Orientation::of_tag(input.spec(0).get_int_attribute("Orientation", 1));
    if (!orientation.upright()) turn_upright(file, orientation);
    return file;
}

}  // namespace

ImageFile read_picture(const fs::path& path) {
    const std::string where = path.string();
    OIIO::ImageSpec as_stored;
    as_stored["oiio:UnassociatedAlpha"] = 1;  // Colour must not be multiplied by alpha.
    try {
        require_plausible_exr_header(path);
        const auto input = OIIO::ImageInput::open(where, &as_stored);
        if (!input) {
            const std::string reason = OIIO::geterror();
            refuse_xyze(path);
            if (is_subsampled_exr(path)) return read_subsampled_exr(path);
            throw unreadable_image(reason, where);
        }
        return read_all_parts(*input, path);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw file_error("needs more memory than there is", where);
    } catch (const std::exception& e) {
        throw unreadable_image(e.what(), where);
    }
}

}  // namespace aoscore
