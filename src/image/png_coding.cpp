#include "image/png_coding.h"

#include "core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <string_view>

namespace aoscore {
namespace {

/// Chunks that say something of colours are short, but for profiles, whose name comes first.
constexpr std::size_t kEnoughBytes = 80;
/// The exponents that files are written with, in the chunk's units, and by how far some differ.
constexpr double kLinearGamma = 100000, kSrgbGamma = 45455, kSameGamma = 0.03;

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

/// The beginnings of the chunks before the pixels, by their names; empty for what is no PNG.
std::map<std::string, std::string> leading_chunks(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::map<std::string, std::string> chunks;
    std::array<char, 8> head{};
    if (!in.read(head.data(), head.size()) ||
        std::string_view(head.data(), head.size()) != "\x89PNG\r\n\x1a\n")
        return {};
    while (in.read(head.data(), head.size())) {
        const std::uint32_t size = big_endian({head.data(), 4});
        const std::string name(head.data() + 4, 4);
        if (name == "IDAT") break;
        std::string data(std::min<std::size_t>(size, kEnoughBytes), '\0');
        in.read(data.data(), static_cast<std::streamsize>(data.size()));
        if (in) chunks.emplace(name, data);
        constexpr std::uint32_t kChecksum_bytes = 4;
        in.seekg(static_cast<std::streamoff>(size - data.size()) + kChecksum_bytes, std::ios::cur);
    }
    return chunks;
}

std::optional<Coding> coding_of_profile(const std::string& chunk) {
    const std::string name = lower_case(chunk.substr(0, chunk.find('\0')));
    if (name.find("linear") != std::string::npos) return Coding::linear;
    if (name.find("srgb") != std::string::npos) return Coding::srgb;
    return std::nullopt;
}

std::optional<Coding> coding_of_gamma(const std::string& chunk) {
    const double gamma = big_endian(chunk);
    if (std::abs(gamma / kLinearGamma - 1) < kSameGamma) return Coding::linear;
    if (std::abs(gamma / kSrgbGamma - 1) < kSameGamma) return Coding::srgb;
    return std::nullopt;
}

}  // namespace

std::optional<StatedCoding> coding_stated_by_png(const std::filesystem::path& path) {
    const auto chunks = leading_chunks(path);
    const auto stated = [](const char* name, std::optional<Coding> coding) -> std::optional<StatedCoding> {
        if (!coding) return std::nullopt;
        return StatedCoding{*coding, std::string("chunk ") + name};
    };
    if (const auto profile = chunks.find("iCCP"); profile != chunks.end())
        return stated("iCCP", coding_of_profile(profile->second));
    if (chunks.contains("sRGB")) return stated("sRGB", Coding::srgb);
    if (const auto gamma = chunks.find("gAMA"); gamma != chunks.end())
        return stated("gAMA", coding_of_gamma(gamma->second));
    return std::nullopt;
}

}  // namespace aoscore
