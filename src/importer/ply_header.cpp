#include "importer/ply_header.h"

#include "core/error.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <iterator>
#include <sstream>

namespace aoscore::importer {
namespace {

struct NumberName {
    std::string_view name, other_name;
    std::size_t bytes;
};
/// The names and sizes of types, in the order of PlyNumber.
constexpr std::array<NumberName, 8> kNumbers{{{"char", "int8", 1},
                                              {"uchar", "uint8", 1},
                                              {"short", "int16", 2},
                                              {"ushort", "uint16", 2},
                                              {"int", "int32", 4},
                                              {"uint", "uint32", 4},
                                              {"float", "float32", 4},
                                              {"double", "float64", 8}}};

using Words = std::vector<std::string>;

/// Reads line after line, and keeps the number of the line for messages.
class HeaderParser {
  public:
    explicit HeaderParser(std::string_view content) : content_(content) {
        // All lines end as the first one does; a number behind the header may begin with either byte.
        const std::size_t end = content.find_first_of("\r\n");
        if (end == content.npos) return;
        line_end_ = content.substr(end, content.substr(end).starts_with("\r\n") ? 2 : 1);
    }

    PlyHeader parse() {
        const Words magic = next_line();
        if (magic.size() != 1 || (magic[0] != "ply" && magic[0] != "PLY"))
            fail("is no PLY file", "ply on the first line");
        for (;;) {
            const Words words = next_line();
            if (words.size() == 1 && words[0] == "end_header") break;
            if (!words.empty()) take(words);
        }
        if (!has_format_) fail("states no format", kFormats);
        header_.end = at_;
        return std::move(header_);
    }

  private:
    static constexpr const char* kFormats = "ascii, binary_little_endian or binary_big_endian";

    [[noreturn]] void fail(const std::string& what, const char* valid) const {
        throw file_error(what, fmt::format("line {}", line_), valid);
    }

    Words next_line() {
        ++line_;
        const std::size_t end = line_end_.empty() ? content_.npos : content_.find(line_end_, at_);
        if (end == content_.npos) fail("ends within its header", "a line end_header");
        std::istringstream line{std::string(content_.substr(at_, end - at_))};
        at_ = end + line_end_.size();
        return {std::istream_iterator<std::string>(line), {}};
    }

    void take(const Words& words) {
        if (words[0] == "comment") {
            if (words.size() > 2 && words[1] == "TextureFile")
                header_.textures.push_back(name_from(words, 2));
        } else if (words[0] == "format") {
            take_format(words);
        } else if (words[0] == "element") {
            take_element(words);
        } else if (words[0] == "property") {
            take_property(words);
        }
        // Any other line is a remark: some programs write theirs without the word comment.
    }

    static std::string name_from(const Words& words, std::size_t first) {
        std::string name = words[first];
        for (std::size_t i = first + 1; i < words.size(); ++i) name += " " + words[i];
        return name;
    }

    void take_format(const Words& words) {
        using enum PlyHeader::Encoding;
        const std::string name = words.size() > 1 ? words[1] : "";
        if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
            fail("has the format " + gltf::printable(name), kFormats);
        header_.encoding = name == "ascii"                  ? text
                           : name == "binary_little_endian" ? little_endian
                                                            : big_endian;
        has_format_ = true;
    }

    void take_element(const Words& words) {
        PlyElement element;
        if (words.size() == 3) {
            const char* const end = words[2].data() + words[2].size();
            const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
            if (error == std::errc() && stop == end) {
                element.name = words[1];
                header_.elements.push_back(std::move(element));
                return;
            }
        }
        fail("states an element without a count", "element vertex 8");
    }

    PlyNumber number_of(const std::string& name) const {
        for (std::size_t i = 0; i < kNumbers.size(); ++i) {
            if (name == kNumbers[i].name || name == kNumbers[i].other_name) return static_cast<PlyNumber>(i);
        }
        fail("has the type " + gltf::printable(name),
             "char, uchar, short, ushort, int, uint, float, double, or int8 to float64");
    }

    void take_property(const Words& words) {
        if (header_.elements.empty()) fail("states a property before any element", "element vertex 8");
        PlyProperty property;
        if (words.size() == 5 && words[1] == "list") {
            property = {words[4], number_of(words[3]), number_of(words[2])};
        } else if (words.size() == 3) {
            property = {words[2], number_of(words[1]), std::nullopt};
        } else {
            fail("states a property without a type and a name",
                 "property float x, property list uchar int vertex_indices");
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    std::string_view content_, line_end_;
    std::size_t at_ = 0, line_ = 0;
    bool has_format_ = false;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyNumber type) {
    return kNumbers[static_cast<std::size_t>(type)].bytes;
}

PlyHeader read_ply_header(std::string_view content) {
    return HeaderParser(content).parse();
}

}  // namespace aoscore::importer
