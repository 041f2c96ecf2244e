#include "scene/gltf/image_decoder.h"

#include "core/error.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace aoscore::gltf {
namespace {

constexpr std::int64_t kMaxSide = 8192;

/// The reader's name for the image's first bytes; only what glTF allows is tried, whatever OpenImageIO reads.
const char* format_of(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "png";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "jpeg";
    if (bytes.size() >= 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP") return "webp";
    return nullptr;
}

glm::u8vec4 to_rgba(const std::uint8_t* pixel, int channels) {
    switch (channels) {
        case 1:
            return {pixel[0], pixel[0], pixel[0], 255};
        case 2:
            return {pixel[0], pixel[0], pixel[0], pixel[1]};
        case 3:
            return {pixel[0], pixel[1], pixel[2], 255};
        default:
            return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
}

}  // namespace

std::optional<Image<glm::u8vec4>> decode_image(std::string_view bytes, MemoryBudget& budget,
                                               std::string& reason) {
    const char* format = format_of(bytes);
    if (format == nullptr) {
        reason = "is no PNG, JPEG or WebP";
        return std::nullopt;
    }
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec config, spec;
    config["oiio:UnassociatedAlpha"] = 1;
    reason = "is broken";
    if (!input || !input->valid_file(format)) {
    }
    if (!input || !input->set_ioproxy(&memory) || !input->open(format, spec, config)) {
        OIIO::geterror();
        return std::nullopt;
    }
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxSide || spec.height > kMaxSide ||
        spec.nchannels < 1 || spec.nchannels > 4) {
        reason =
            fmt::format("has {} x {} pixels of {} channels, more than the 8192 x 8192 of 4 that are read",
                        spec.width, spec.height, spec.nchannels);
        return std::nullopt;
    }
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    try {
        budget.take(pixels * (channels + sizeof(glm::u8vec4)), "");
    } catch (const Error&) {
        reason = "does not fit into the memory that a scene may take (1 GiB)";
        return std::nullopt;
    }
    std::vector<std::uint8_t> samples(pixels * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, samples.data())) {
        static_cast<void>(input->geterror());
        return std::nullopt;
    }
    Image<glm::u8vec4> image(spec.width, spec.height);
    for (std::size_t i = 0; i < pixels; ++i)
        image.pixels[i] = to_rgba(&samples[i * channels], spec.nchannels);
    reason.clear();
    return image;
}

}  // namespace aoscore::gltf
