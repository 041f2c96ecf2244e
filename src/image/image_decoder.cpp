#include "image/image_decoder.h"

#include "core/error.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <png.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace aoscore {
namespace {

constexpr std::int64_t kMaxSide = 8192;

/// The name of the reader by the image's first bytes. OpenImageIO reads more formats than glTF allows; only
/// those are tried.
std::string_view format_of(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "png";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "jpeg";
    if (bytes.size() >= 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP") return "webp";
    return {};
}

/// The name of a format that glTF's extensions allow and nothing here decodes.
std::string_view undecoded_format(std::string_view bytes) {
    if (bytes.starts_with("\xABKTX 20\xBB\r\n\x1A\n")) return "KTX2 (Basis Universal)";
    if (bytes.starts_with("DDS ")) return "DDS";
    if (bytes.size() >= 12 && bytes.substr(4, 8) == "ftypavif") return "AVIF";
    return {};
}

bool fits(std::int64_t width, std::int64_t height, int channels, MemoryBudget& budget, std::string& reason) {
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || channels < 1 || channels > 4) {
        reason = fmt::format("has {} x {} pixels of {} channels, more than the {} x {} of 4 that are read",
                             width, height, channels, kMaxSide, kMaxSide);
        return false;
    }
    try {
        // Counts the decoder's samples as well as the texels.
        budget.take(static_cast<std::size_t>(width * height) * 2 * sizeof(glm::u8vec4), "");
    } catch (const Error&) {
        reason = "does not fit into the memory that a scene may take (1 GiB)";
        return false;
    }
    return true;
}

/// Calls libpng itself: OpenImageIO lets it write its complaints to standard error.
std::optional<Image<glm::u8vec4>> decode_png(std::string_view bytes, MemoryBudget& budget,
                                             std::string& reason) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return std::nullopt;
    const std::unique_ptr<png_image, decltype(&png_image_free)> release(&png, png_image_free);
    if (!fits(png.width, png.height, 4, budget, reason)) return std::nullopt;
    png.format = PNG_FORMAT_RGBA;
    Image<glm::u8vec4> image(static_cast<int>(png.width), static_cast<int>(png.height));
    if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) return std::nullopt;
    return image;
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

std::optional<Image<glm::u8vec4>> decode_image_as(const char* format, std::string_view bytes,
                                                  MemoryBudget& budget, std::string& reason) {
    reason = "is broken";
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec config, spec;
    config["oiio:UnassociatedAlpha"] = 1;
    if (!input || !input->set_ioproxy(&memory) || !input->open(format, spec, config)) {
        // The message may quote the file; it is fetched here so that nobody else reports it.
        static_cast<void>(input ? input->geterror() : OIIO::geterror());
        return std::nullopt;
    }
    if (!fits(spec.width, spec.height, spec.nchannels, budget, reason)) return std::nullopt;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Image<glm::u8vec4> image(spec.width, spec.height);
    std::vector<std::uint8_t> samples(image.size() * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, samples.data())) {
        static_cast<void>(input->geterror());
        return std::nullopt;
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        image.pixels[i] = to_rgba(&samples[i * channels], spec.nchannels);
    }
    return image;
}

std::optional<Image<glm::u8vec4>> decode_image(std::string_view bytes, MemoryBudget& budget,
                                               std::string& reason) {
    const std::string_view format = format_of(bytes);
    const std::string_view other = undecoded_format(bytes);
    if (format.empty()) {
        reason = other.empty() ? "is no PNG, JPEG or WebP"
                               : fmt::format("is {}, which is not decoded here", other);
        return std::nullopt;
    }
    reason = "is broken";
    return format == "png" ? decode_png(bytes, budget, reason)
                           : decode_image_as(format.data(), bytes, budget, reason);
}

}  // namespace aoscore
