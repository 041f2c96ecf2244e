#include "image/image_decoder.h"

#include "image/image_formats.h"
#include "image/image_limits.h"

#include <fmt/format.h>
#include <png.h>

#include <memory>

namespace aoscore {
namespace {

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

/// Calls libpng itself: OpenImageIO lets it write its complaints to standard error.
std::optional<Image<glm::u8vec4>> decode_png(std::string_view bytes, MemoryBudget& budget,
                                             std::string& reason) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return std::nullopt;
    const std::unique_ptr<png_image, decltype(&png_image_free)> release(&png, png_image_free);
    if (!texture_fits(png.width, png.height, 4, budget, reason)) return std::nullopt;
    png.format = PNG_FORMAT_RGBA;
    Image<glm::u8vec4> image(static_cast<int>(png.width), static_cast<int>(png.height));
    if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) return std::nullopt;
    return image;
}

}  // namespace

std::optional<Image<glm::u8vec4>> decode_image_as(const char* format, std::string_view bytes,
                                                  MemoryBudget& budget, std::string& reason) {
    return image_formats().decode(format, bytes, budget, reason);
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
