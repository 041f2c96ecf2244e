#include "formats/image_strips.h"

#include "image/image_limits.h"

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace aoscore {
namespace {

constexpr int kStripRows = 256;

/// Says how values become float: they are read as `type` and divided by `scale`.
struct Coding {
    OIIO::TypeDesc type;
    float scale;
};

Coding coding_of(const OIIO::ImageSpec& spec) {
    if (spec.format == OIIO::TypeUInt8) return {OIIO::TypeUInt8, 255.0F};
    if (spec.format == OIIO::TypeUInt16) return {OIIO::TypeUInt16, 65535.0F};
    return {OIIO::TypeFloat, 1.0F};
}

/// Copies interleaved values of one strip after another into the channels.
template <class Value>
void read_values(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int subimage, Coding coding,
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
        if (!read) throw unreadable_image(input.geterror(), where);
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

}  // namespace

void read_strips(OIIO::ImageInput& input, int subimage, const std::string& where,
                 std::vector<ImageF>& channels) {
    const OIIO::ImageSpec spec = input.spec(subimage);
    const Coding coding = coding_of(spec);
    if (coding.type == OIIO::TypeUInt8) {
        read_values<std::uint8_t>(input, spec, subimage, coding, where, channels);
    } else if (coding.type == OIIO::TypeUInt16) {
        read_values<std::uint16_t>(input, spec, subimage, coding, where, channels);
    } else {
        read_values<float>(input, spec, subimage, coding, where, channels);
    }
}

}  // namespace aoscore
