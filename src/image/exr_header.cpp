#include "image/exr_header.h"

#include "core/error.h"
#include "core/printable.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace aoscore {
namespace {

// The layout is that of OpenEXR's document "OpenEXR File Layout".
constexpr std::uint32_t kMagic = 0x01312f76, kSeveralParts = 0x1000;
constexpr std::uint32_t kBoxBytes = 16;

/// Reads a little-endian number.
std::uint32_t read_number(std::istream& in) {
    std::array<unsigned char, 4> bytes{};
    in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) number |= std::uint32_t{bytes[i]} << (8 * i);
    return number;
}

/// Reads the characters before the next zero.
std::string read_word(std::istream& in) {
    std::string word;
    std::getline(in, word, '\0');
    return word;
}

void require_plausible_window(std::istream& in, std::uintmax_t bytes, const std::string& where) {
    std::array<std::int64_t, 4> corners{};  // least x and y, greatest x and y
    for (std::int64_t& corner : corners) corner = static_cast<std::int32_t>(read_number(in));
    const std::int64_t width = corners[2] - corners[0] + 1, height = corners[3] - corners[1] + 1;
    if (1.0 * width * height <= static_cast<double>(bytes) * kMostValuesAByteOfDwa) return;
    throw file_error(
        fmt::format("claims a picture of {}x{} pixels, more than {} bytes can hold", width, height, bytes),
        where, "a whole EXR file");
}

/// Skips the attributes of one part; false where there are none.
bool skip_attributes(std::istream& in, std::uintmax_t bytes, const std::string& where) {
    bool any = false;
    for (std::string name = read_word(in); in && !name.empty(); name = read_word(in)) {
        any = true;
        read_word(in);  // the attribute's type
        const std::uint32_t size = read_number(in);
        if (!in) return false;
        if (size > bytes - static_cast<std::uintmax_t>(in.tellg()))
            throw file_error(fmt::format("its attribute {} claims {} bytes of the {} that there are",
                                         printable(name), size, bytes),
                             where, "a whole EXR file");
        if (name == "dataWindow" && size == kBoxBytes) {
            require_plausible_window(in, bytes, where);
        } else {
            in.seekg(size, std::ios::cur);
        }
    }
    return any && in;
}

}  // namespace

void require_plausible_exr_header(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (read_number(in) != kMagic) return;
    const bool several = (read_number(in) & kSeveralParts) != 0;
    const std::uintmax_t bytes = std::filesystem::file_size(path);
    while (skip_attributes(in, bytes, path.string()) && several) {
    }
}

}  // namespace aoscore
