#pragma once

#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore::testing {

/// Writes small glTF files for tests: a document with one external buffer, to which accessors are appended.
class GltfFile {
  public:
    /// Begins a file with an asset, one scene and no nodes.
    GltfFile();

    nlohmann::json document;
    nlohmann::json fallback;  ///< a second buffer as JSON; null: none

    /// Appends the values, 4-byte aligned, and returns the index of their accessor.
    template <class T>
    int add_accessor(const std::vector<T>& values, const std::string& type, int components) {
        const int view = add_view(values.data(), values.size() * sizeof(T));
        document["accessors"].push_back({{"bufferView", view},
                                         {"componentType", component_type(T{})},
                                         {"count", values.size() / static_cast<std::size_t>(components)},
                                         {"type", type}});
        return static_cast<int>(document["accessors"].size()) - 1;
    }
    int add_positions(const std::vector<float>& xyz);
    int add_view(const void* data, std::size_t bytes);
    /// Adds a mesh of one primitive with these members; returns its index.
    int add_mesh(const nlohmann::json& primitive);
    /// Adds a node at the root; returns its index.
    int add_node(const nlohmann::json& node);
    /// Adds a mesh of a box from `low` to `high`; returns its index.
    int add_box(const glm::vec3& low, const glm::vec3& high);
    /// Adds a PNG of one row of RGBA texels to the buffer, with a texture of that sampler; returns the
    /// texture's index.
    int add_texture(const Image<glm::u8vec4>& texels,
                    const nlohmann::json& sampler = nlohmann::json::object());

    /// Writes name.gltf and name.bin to the folder; returns the path of the first.
    std::filesystem::path write(const std::filesystem::path& folder, const std::string& name = "test");
    /// Writes the file and loads it.
    Scene load(const std::filesystem::path& folder, const LoadOptions& options = {});

    /// The error of load(); empty when it loads.
    std::string refusal(const std::filesystem::path& folder);

  private:
    static int component_type(std::int8_t) { return 5120; }
    static int component_type(std::uint8_t) { return 5121; }
    static int component_type(std::int16_t) { return 5122; }
    static int component_type(std::uint16_t) { return 5123; }
    static int component_type(std::uint32_t) { return 5125; }
    static int component_type(float) { return 5126; }

    std::vector<char> buffer_;
};

/// A PNG file of these texels.
std::string png_bytes(const Image<glm::u8vec4>& texels);
/// Whether a warning contains this text.
bool has_warning(const Scene& scene, const std::string& part);

/// The three corners of triangle `i` of an instance, in scene space.
std::vector<glm::dvec3> corners(const Scene& scene, const Instance& instance, std::size_t i);
/// The corners of all triangles of the scene, in the order of instances.
std::vector<glm::dvec3> all_corners(const Scene& scene);

}  // namespace aoscore::testing
