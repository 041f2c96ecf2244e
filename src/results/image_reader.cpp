#include "core/error.h"
#include "results/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <concepts>
#include <map>
#include <new>

namespace aoscore {
namespace {

// What a header may claim before anything is allocated for it.
constexpr int kMostChannels = 1024;
constexpr std::size_t kMostSamples = std::size_t{1} << 30;
constexpr int kStripRows = 256;

namespace fs = std::filesystem;

/// A library's complaint may span lines, and name the file again on each.
Error unreadable(const std::string& complaint, const std::string& where) {
    std::string text = complaint;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return file_error("cannot be read: " + text, where, "a whole image file");
}

void require_readable(const OIIO::ImageSpec& spec, const std::string& where) {
    if (spec.deep) throw file_error("is a deep image", where, "a flat one");
    if (spec.depth > 1) throw file_error("is a volume", where, "an image");
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throw file_error("is empty", where);
    const auto samples = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                         static_cast<std::size_t>(spec.nchannels);
    if (spec.width > kLargestImageSide_px || spec.height > kLargestImageSide_px ||
        spec.nchannels > kMostChannels || samples > kMostSamples) {
        throw file_error(
            fmt::format("claims {}x{} pixels of {} channels", spec.width, spec.height, spec.nchannels), where,
            fmt::format("at most {0}x{0} pixels, {1} channels, {2} values", kLargestImageSide_px,
                        kMostChannels, kMostSamples));
    }
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height) {
        throw file_error(
            fmt::format("holds {}x{} pixels at {}, {} of a frame of {}x{} at {}, {}", spec.width, spec.height,
                        spec.x, spec.y, spec.full_width, spec.full_height, spec.full_x, spec.full_y),
            where, "all pixels of the frame and no others");
    }
}

/// Refuses an EXR whose header claims more values than the file's bytes can hold, in its picture or in one of
/// its tiles: memory would be filled with what is not there. `bytes` is the file's size.
void require_plausible_exr(const OIIO::ImageSpec& spec, std::uintmax_t bytes, const std::string& where) {
    // Deflate makes a byte of at most 1032 (RFC 1951), 516 values of 16 bits. DWA's keeps 2 bytes of a block
    // of 64 equal values before that.
    constexpr double kMostValuesAByte = 516, kMostValuesAByteOfDwa = 64.0 / 2 * 1032;
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

/// How the file's values become float: read as `type` and divided by `scale`.
struct Coding {
    OIIO::TypeDesc type;
    float scale;
};

Coding coding_of(const OIIO::ImageSpec& spec) {
    if (spec.format == OIIO::TypeUInt8) return {OIIO::TypeUInt8, 255.0F};
    if (spec.format == OIIO::TypeUInt16) return {OIIO::TypeUInt16, 65535.0F};
    return {OIIO::TypeFloat, 1.0F};
}

/// Copies interleaved values of one strip into the channels, which are made when the first strip is there: a
/// header alone, however large its claims, takes no memory.
template <class Value>
void read_strips(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int subimage, Coding coding,
                 const std::string& where, std::vector<ImageF>& channels) {
    const int rows =
        spec.tile_height > 0 ? std::max(kStripRows / spec.tile_height, 1) * spec.tile_height : kStripRows;
    const auto count = static_cast<std::size_t>(spec.nchannels);
    const std::size_t first_channel = channels.size();
    std::vector<Value> strip(static_cast<std::size_t>(spec.width) * count *
                             static_cast<std::size_t>(std::min(rows, spec.height)));
    for (int y = 0; y < spec.height; y += rows) {
        const int end = std::min(y + rows, spec.height);
        const bool read =
            spec.tile_width > 0
                ? input.read_tiles(subimage, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z,
                                   spec.z + 1, 0, spec.nchannels, coding.type, strip.data())
                : input.read_scanlines(subimage, 0, spec.y + y, spec.y + end, spec.z, 0, spec.nchannels,
                                       coding.type, strip.data());
        if (!read) throw unreadable(input.geterror(), where);
        if (y == 0) channels.resize(first_channel + count, ImageF(spec.width, spec.height));
        for (std::size_t c = 0; c < count; ++c) {
            float* to = &channels[first_channel + c].at(0, y);
            const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(end - y);
            for (std::size_t i = 0; i < pixels; ++i) {
                if constexpr (std::same_as<Value, float>) {
                    to[i] = strip[i * count + c];  // Not even a division by 1, which alters signalling NaN.
                } else {
                    to[i] = static_cast<float>(strip[i * count + c]) / coding.scale;
                }
            }
        }
    }
}

void read_part(OIIO::ImageInput& input, int subimage, const std::string& where, ImageFile& file) {
    const OIIO::ImageSpec spec = input.spec(subimage);
    const Coding coding = coding_of(spec);
    if (coding.type == OIIO::TypeUInt8) {
        read_strips<std::uint8_t>(input, spec, subimage, coding, where, file.channels);
    } else if (coding.type == OIIO::TypeUInt16) {
        read_strips<std::uint16_t>(input, spec, subimage, coding, where, file.channels);
    } else {
        read_strips<float>(input, spec, subimage, coding, where, file.channels);
    }
    const std::string part(spec.get_string_attribute("oiio:subimagename"));
    for (const std::string& name : spec.channelnames) {
        const bool named_by_part = subimage > 0 && !part.empty() && !name.starts_with(part + ".");
        file.channel_names.push_back(named_by_part ? part + "." + name : name);
    }
}

/// Of EXR's standard attributes, those that OpenImageIO renames.
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

ImageFile read_all_parts(OIIO::ImageInput& input, const fs::path& path) {
    const std::string where = path.string();
    const OIIO::ImageSpec first = input.spec(0);
    require_readable(first, where);
    ImageFile file;
    file.width = first.width;
    file.height = first.height;
    file.integers = !first.format.is_floating_point();
    const bool exr = std::string_view(input.format_name()) == "openexr";
    const std::uintmax_t bytes = fs::file_size(path);
    if (exr) require_plausible_exr(first, bytes, where);
    file.attributes = attributes_of(first, exr);
    read_part(input, 0, where, file);
    // Other programs put layers into parts.
    for (int subimage = 1; exr && input.seek_subimage(subimage, 0); ++subimage) {
        const OIIO::ImageSpec spec = input.spec(subimage);
        if (spec.deep || spec.width != first.width || spec.height != first.height) continue;
        require_readable(spec, where);
        require_plausible_exr(spec, bytes, where);
        read_part(input, subimage, where, file);
    }
    return file;
}

}  // namespace

const ImageF* ImageFile::channel(const std::string& name) const {
    const auto found = std::ranges::find(channel_names, name);
    return found == channel_names.end() ? nullptr
                                        : &channels[static_cast<std::size_t>(found - channel_names.begin())];
}

ImageFile read_image(const fs::path& path) {
    const std::string where = path.string();
    std::error_code ec;
    const fs::file_status status = fs::status(path, ec);
    if (!fs::exists(status)) throw file_error("no such file", where);
    if (!fs::is_regular_file(status)) throw file_error("not a regular file", where);
    OIIO::ImageSpec as_stored;
    as_stored["oiio:UnassociatedAlpha"] = 1;  // Colour is not to be multiplied by alpha.
    try {
        const auto input = OIIO::ImageInput::open(where, &as_stored);
        if (!input) throw unreadable(OIIO::geterror(), where);
        return read_all_parts(*input, path);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw file_error("needs more memory than there is", where);
    } catch (const std::exception& e) {
        throw unreadable(e.what(), where);
    }
}

}  // namespace aoscore
