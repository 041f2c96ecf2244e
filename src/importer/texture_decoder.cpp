#include "importer/texture_decoder.h"

#include "image/image_decoder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace aoscore::importer {
namespace {

struct Kind {
    std::string_view first_bytes;
    const char* reader;
};
constexpr std::array<Kind, 6> kKinds{{{"BM", "bmp"},
                                      {"DDS ", "dds"},
                                      {std::string_view("II*\0", 4), "tiff"},
                                      {std::string_view("MM\0*", 4), "tiff"},
                                      {"GIF8", "gif"},
                                      {"8BPS", "psd"}}};

const char* reader_for(const std::string& name, std::string_view bytes) {
    for (const Kind& kind : kKinds) {
        if (bytes.starts_with(kind.first_bytes)) return kind.reader;
    }
    std::string extension = std::filesystem::path(name).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return extension == ".tga" ? "targa" : nullptr;
}

}  // namespace

std::optional<Image<glm::u8vec4>> decode_texture(const std::string& name, std::string_view bytes,
                                                 MemoryBudget& budget, std::string& reason) {
    const char* reader = reader_for(name, bytes);
    if (reader != nullptr) return decode_image_as(reader, bytes, budget, reason);
    std::optional<Image<glm::u8vec4>> image = decode_image(bytes, budget, reason);
    if (!image && reason == "is no PNG, JPEG or WebP") reason = "is of no kind that is read";
    return image;
}

bool may_have_alpha(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xD8\xFF")) return false;  // JPEG
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 26) return true;
    // A PNG (ISO/IEC 15948) has alpha by its colour type, or by a chunk that makes some colours transparent.
    constexpr char kHasAlpha = 4;
    return (bytes[25] & kHasAlpha) != 0 || bytes.substr(0, bytes.find("IDAT")).find("tRNS") != bytes.npos;
}

}  // namespace aoscore::importer
