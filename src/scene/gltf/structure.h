#pragma once

#include "scene/gltf/checked_object.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::gltf {

/// The numbers of elements of the document's arrays, which limit indices.
struct Counts {
    std::size_t buffers, buffer_views, accessors, meshes, materials, textures, images, samplers, nodes,
        cameras, skins, scenes;
};

/// The limit of all offsets, lengths and counts, so that products of them with a stride, at most 256, do not
/// overflow 64 bits.
inline constexpr std::int64_t kMaxBytes = std::int64_t{1} << 40;
inline constexpr std::int64_t kMaxCount = std::int64_t{1} << 32;

/// Proves that the document is sound wherever this program or tinygltf reads it: types, ranges, indices, the
/// extents of views and accessors. tinygltf itself checks little of that. Binary data (index values,
/// positions) are checked where they are decoded. Throws file_error with the place; legal or harmless things
/// that are not read become `warnings`. Names follow the glTF 2.0 specification (Khronos 2021).
void check_structure(nlohmann::json& root, const std::string& where, std::vector<std::string>& warnings);

/// Parts of check_structure(), each in a file of its own.
void check_asset_and_extensions(CheckedObject& root, const std::set<std::string>& carried,
                                std::vector<std::string>& warnings);
void check_buffers_and_accessors(CheckedObject& root, const Counts& counts,
                                 std::vector<std::string>& warnings);
/// Checks EXT_meshopt_compression or KHR_meshopt_compression in a buffer view of `bytes`, where it has one.
void check_compressed_view(CheckedObject& view, std::int64_t bytes,
                           const std::vector<std::int64_t>& buffer_bytes);
void check_meshes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings);
void check_nodes_and_scenes(CheckedObject& root, const Counts& counts, std::vector<std::string>& warnings);
void check_cameras(CheckedObject& root, std::vector<std::string>& warnings);
void check_materials_and_textures(CheckedObject& root, const Counts& counts,
                                  std::vector<std::string>& warnings);

/// The bytes of one component of that type (5120 …); 0 for a type that glTF does not have.
std::size_t component_bytes(std::int64_t component_type);
/// The number of components of an element of type "SCALAR", "VEC2", …; 0 for an unknown type.
std::size_t component_count(std::string_view type);

}  // namespace aoscore::gltf
