#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::importer {

enum class PlyNumber : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The size of a number in bytes.
std::size_t size_of(PlyNumber type);

struct PlyProperty {
    std::string name;
    PlyNumber type = PlyNumber::float32;
    std::optional<PlyNumber> count_type;  ///< for a list: the type of the count before its numbers
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

/// The first lines of a Stanford polygon file, which say what its numbers mean.
struct PlyHeader {
    enum class Encoding : std::uint8_t { text, little_endian, big_endian };
    Encoding encoding = Encoding::text;
    std::vector<PlyElement> elements;   ///< elements in the order of their numbers in the file
    std::vector<std::string> textures;  ///< image files that its comments name, as MeshLab writes them
    std::size_t end = 0;                ///< where the numbers begin
};

/// Reads the header. Throws file_error with the line.
PlyHeader read_ply_header(std::string_view content);

}  // namespace aoscore::importer
