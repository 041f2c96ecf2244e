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

/// A curve by the words of a chunk; none for curves that are not known here.
struct Curve {
    std::optional<Coding> coding;
    const char* name;
};
constexpr Curve kLinear{Coding::linear, "linear"}, kSrgb{Coding::srgb, "sRGB-coded"}, kPq{{}, "coded by PQ"},
    kHlg{{}, "coded by HLG"}, kLimited{{}, "of limited range"};

/// The curves of code points of transfer characteristics (ITU-T, Recommendation H.273, table 3). Limited
/// range, in which black and white are not the least and the greatest integer, goes before every curve.
std::optional<Curve> curve_of_code_points(const std::string& chunk) {
    static const std::map<int, Curve> kCurves = {{1, {{}, "coded by the curve of video, BT.709"}},
                                                 {4, {{}, "coded by a gamma of 2.2, BT.470 M"}},
                                                 {5, {{}, "coded by a gamma of 2.8, BT.470 B, G"}},
                                                 {6, {{}, "coded by the curve of video, BT.601"}},
                                                 {7, {{}, "coded by the curve of video, SMPTE 240M"}},
                                                 {8, kLinear},
                                                 {9, {{}, "logarithmic"}},
                                                 {10, {{}, "logarithmic"}},
                                                 {11, {{}, "coded by the curve of video, IEC 61966-2-4"}},
                                                 {12, {{}, "coded by the curve of video, BT.1361"}},
                                                 {13, kSrgb},
                                                 {14, {{}, "coded by the curve of video, BT.2020"}},
                                                 {15, {{}, "coded by the curve of video, BT.2020"}},
                                                 {16, kPq},
                                                 {17, {{}, "coded by the curve of cinema, SMPTE ST 428-1"}},
                                                 {18, kHlg}};
    constexpr std::size_t kTransfer = 1, kFullRange = 3;
    if (chunk[kFullRange] == 0) return kLimited;
    const auto found = kCurves.find(static_cast<unsigned char>(chunk[kTransfer]));
    return found == kCurves.end() ? std::nullopt : std::optional(found->second);
}

/// A profile's curve by its name; that of PQ was fixed before there were code points (W3C, Using the ITU
/// BT.2100 PQ EOTF with the PNG Format, 2017).
std::optional<Curve> curve_of_profile(const std::string& chunk) {
    const std::string name = lower_case(chunk.substr(0, chunk.find('\0')));
    if (name.find("2100_pq") != std::string::npos) return kPq;
    if (name.find("linear") != std::string::npos) return kLinear;
    if (name.find("srgb") != std::string::npos) return kSrgb;
    return std::nullopt;
}

std::optional<Curve> curve_of_gamma(const std::string& chunk) {
    const double gamma = big_endian(chunk);
    if (std::abs(gamma / kLinearGamma - 1) < kSameGamma) return kLinear;
    if (std::abs(gamma / kSrgbGamma - 1) < kSameGamma) return kSrgb;
    return std::nullopt;
}

std::optional<Curve> curve_of_srgb(const std::string&) {
    return kSrgb;
}

}  // namespace

std::optional<StatedCoding> coding_stated_by_png(const std::filesystem::path& path) {
    const auto chunks = leading_chunks(path);
    struct Statement {
        const char* chunk;
        std::optional<Curve> (*curve)(const std::string&);
        std::size_t size;  ///< in bytes, without which the chunk counts as none; 0: any
    };
    static constexpr Statement kByRank[] = {{"cICP", curve_of_code_points, 4},
                                            {"iCCP", curve_of_profile, 0},
                                            {"sRGB", curve_of_srgb, 1},
                                            {"gAMA", curve_of_gamma, 4}};
    for (const Statement& statement : kByRank) {
        const auto found = chunks.find(statement.chunk);
        if (found == chunks.end()) continue;
        if (statement.size != 0 && found->second.size() != statement.size) continue;
        const std::optional<Curve> curve = statement.curve(found->second);
        if (!curve) return std::nullopt;
        return StatedCoding{curve->coding, curve->name, std::string("chunk ") + statement.chunk};
    }
    return std::nullopt;
}

}  // namespace aoscore
