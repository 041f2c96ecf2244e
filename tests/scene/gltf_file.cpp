#include "gltf_file.h"

#include "core/error.h"

#include <png.h>

#include <algorithm>
#include <fstream>

namespace aoscore::testing {

using nlohmann::json;

GltfFile::GltfFile() {
    document = {
        {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", nlohmann::json::array()}}}}};
}

int GltfFile::add_view(const void* data, std::size_t bytes) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    const std::size_t offset = buffer_.size();
    buffer_.resize(offset + bytes);
    std::memcpy(buffer_.data() + offset, data, bytes);
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
    return static_cast<int>(document["bufferViews"].size()) - 1;
}

int GltfFile::add_positions(const std::vector<float>& xyz) {
    const int accessor = add_accessor(xyz, "VEC3", 3);
    // The specification requires bounds; the loader does not trust them.
    document["accessors"].back()["min"] = {0, 0, 0};
    document["accessors"].back()["max"] = {1, 1, 1};
    return accessor;
}

int GltfFile::add_mesh(const nlohmann::json& primitive) {
    document["meshes"].push_back({{"primitives", {primitive}}});
    return static_cast<int>(document["meshes"].size()) - 1;
}

int GltfFile::add_node(const nlohmann::json& node) {
    document["nodes"].push_back(node);
    const int index = static_cast<int>(document["nodes"].size()) - 1;
    document["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfFile::add_box(const glm::vec3& low, const glm::vec3& high) {
    std::vector<float> positions;
    for (int corner = 0; corner < 8; ++corner) {
        positions.push_back((corner & 1) != 0 ? high.x : low.x);
        positions.push_back((corner & 2) != 0 ? high.y : low.y);
        positions.push_back((corner & 4) != 0 ? high.z : low.z);
    }
    const std::vector<std::uint16_t> indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return add_mesh({{"attributes", {{"POSITION", add_positions(positions)}}},
                     {"indices", add_accessor(indices, "SCALAR", 1)}});
}

std::string png_bytes(const Image<glm::u8vec4>& texels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(texels.width);
    png.height = static_cast<png_uint_32>(texels.height);
    png.format = PNG_FORMAT_RGBA;
    std::string bytes(4096 + texels.size() * 8, '\0');
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, texels.pixels.data(), 0, nullptr) == 0) {
        throw std::runtime_error("PNG was not written");
    }
    bytes.resize(size);
    return bytes;
}

int GltfFile::add_texture(const Image<glm::u8vec4>& texels, const nlohmann::json& sampler) {
    const std::string bytes = png_bytes(texels);
    const int view = add_view(bytes.data(), bytes.size());
    document["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    document["samplers"].push_back(sampler);
    document["textures"].push_back(
        {{"source", document["images"].size() - 1}, {"sampler", document["samplers"].size() - 1}});
    return static_cast<int>(document["textures"].size()) - 1;
}

std::filesystem::path GltfFile::write(const std::filesystem::path& folder, const std::string& name) {
    if (!buffer_.empty()) document["buffers"] = {{{"byteLength", buffer_.size()}, {"uri", name + ".bin"}}};
    if (!fallback.is_null()) document["buffers"].push_back(fallback);
    std::ofstream(folder / (name + ".bin"), std::ios::binary)
        .write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    std::ofstream(folder / (name + ".gltf")) << document.dump(1);
    return folder / (name + ".gltf");
}

Scene GltfFile::load(const std::filesystem::path& folder, const LoadOptions& options) {
    return load_scene(write(folder).string(), options);
}

std::string GltfFile::refusal(const std::filesystem::path& folder) {
    try {
        load(folder);
        return "";
    } catch (const Error& error) {
        return error.exit_code() == ExitCode::file_error ? error.what() : "another exit code";
    }
}

bool has_warning(const Scene& scene, const std::string& part) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

std::vector<glm::dvec3> corners(const Scene& scene, const Instance& instance, std::size_t i) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    std::vector<glm::dvec3> result;
    for (int corner = 0; corner < 3; ++corner) {
        const glm::dvec3 p = mesh.positions[mesh.triangles[i][corner]];
        result.emplace_back(instance.scene_from_mesh * glm::dvec4(p, 1));
    }
    return result;
}

std::vector<glm::dvec3> all_corners(const Scene& scene) {
    std::vector<glm::dvec3> result;
    for (const Instance& instance : scene.instances) {
        const std::size_t count = scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
        for (std::size_t i = 0; i < count; ++i) {
            for (const glm::dvec3& p : corners(scene, instance, i)) result.push_back(p);
        }
    }
    return result;
}

}  // namespace aoscore::testing
