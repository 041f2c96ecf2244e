#include "scene/import/import_formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace aoscore::imported {
namespace {

struct Row {
    Format format;
    std::string_view extension;
    std::string_view name;
};
constexpr std::array<Row, 4> kFormats{{{Format::obj, ".obj", "OBJ"},
                                       {Format::fbx, ".fbx", "FBX"},
                                       {Format::ply, ".ply", "PLY"},
                                       {Format::stl, ".stl", "STL"}}};

}  // namespace

std::optional<Format> format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    for (const Row& row : kFormats) {
        if (row.extension == extension) return row.format;
    }
    return std::nullopt;
}

std::string_view format_name(Format format) {
    return kFormats[static_cast<std::size_t>(format)].name;
}

}  // namespace aoscore::imported
