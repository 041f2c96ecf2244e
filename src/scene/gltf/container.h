#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::gltf {

/// A .gltf or .glb file taken apart: its JSON text and, for GLB, the binary chunk. Both point into `bytes`,
/// hence it never moves.
struct Container {
    Container() = default;
    Container(const Container&) = delete;
    Container& operator=(const Container&) = delete;

    std::string bytes;
    std::string_view json;
    std::optional<std::string_view> binary_chunk;
};

/// Reads the file, whose format follows from its first bytes, not from its name. Throws file_error for an
/// unreadable file and for a GLB whose header or chunks contradict each other or the file's size ("GLB File
/// Format Specification" of glTF 2.0, Khronos 2021). Harmless oddities go to `warnings`.
std::unique_ptr<const Container> read_container(const std::filesystem::path& file, const std::string& where,
                                                std::vector<std::string>& warnings);

}  // namespace aoscore::gltf
