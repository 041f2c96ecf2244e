#include "scene/gltf/write_glb.h"

#include "core/files.h"
#include "image/png_with_alpha.h"

#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

// Constants of the glTF 2.0 specification (Khronos Group, 2021): sections 3.6 and 4.4.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
constexpr std::array<int, 3> kWraps{10497, 33648, 33071};  // in the order of Texture::Wrap

void append_number(std::string& bytes, std::uint32_t number) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i));
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
}

class GlbWriter {
  public:
    explicit GlbWriter(const Scene& scene) : scene_(scene) {
        document_ = {{"asset", {{"version", "2.0"}, {"generator", "aoscore"}}}, {"scene", 0}};
        for (const Material& material : scene.materials) add(material);
        for (const Mesh& mesh : scene.meshes) add(mesh);
        json roots = json::array();
        for (const Instance& instance : scene.instances) {
            roots.push_back(roots.size());
            document_["nodes"].push_back({{"mesh", instance.mesh}, {"matrix", matrix_of(instance)}});
        }
        document_["scenes"] = {{{"nodes", roots}}};
        document_["buffers"] = {{{"byteLength", binary_.size()}}};
    }

    std::string bytes() {
        std::string text = document_.dump();
        pad(text, ' ');
        pad(binary_, '\0');
        std::string file;
        append_number(file, kMagic);
        append_number(file, 2);
        append_number(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary_.size()));
        append_number(file, static_cast<std::uint32_t>(text.size()));
        append_number(file, kJson);
        file += text;
        append_number(file, static_cast<std::uint32_t>(binary_.size()));
        append_number(file, kBinary);
        return file + binary_;
    }

  private:
    static json matrix_of(const Instance& instance) {
        json numbers = json::array();
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) numbers.push_back(instance.scene_from_mesh[column][row]);
        }
        return numbers;
    }

    template <class Bytes>
    int view(const Bytes& bytes, std::size_t size) {
        pad(binary_, '\0');
        document_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
        binary_.append(reinterpret_cast<const char*>(bytes), size);
        return static_cast<int>(document_["bufferViews"].size()) - 1;
    }

    template <class T>
    int accessor(const std::vector<T>& values, std::size_t count, int component, const char* type) {
        static_assert(std::endian::native == std::endian::little);
        document_["accessors"].push_back({{"bufferView", view(values.data(), values.size() * sizeof(T))},
                                          {"componentType", component},
                                          {"count", count},
                                          {"type", type}});
        return static_cast<int>(document_["accessors"].size()) - 1;
    }

    void add(const Material& material) {
        const glm::vec4& c = material.base_color;
        json surface = {
            {"baseColorFactor", {c.r, c.g, c.b, c.a}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
        json row = {{"name", material.name}, {"doubleSided", true}};
        if (material.is_cutout()) {
            row["alphaMode"] = "MASK";
            row["alphaCutoff"] = material.alpha_cutoff;
            if (material.texture >= 0)
                surface["baseColorTexture"] = {{"index", add_texture(material.texture)}};
        }
        row["pbrMetallicRoughness"] = surface;
        document_["materials"].push_back(row);
    }

    int add_texture(int index) {
        const Texture& texture = scene_.textures[static_cast<std::size_t>(index)];
        Image<std::array<std::uint8_t, 4>> colours(texture.texels.width, texture.texels.height);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const glm::u8vec4& t = texture.texels.pixels[i];
            colours.pixels[i] = {t.r, t.g, t.b, t.a};
        }
        const std::string png = encode_png_rgba(colours);
        document_["images"].push_back(
            {{"bufferView", view(png.data(), png.size())}, {"mimeType", "image/png"}});
        document_["samplers"].push_back({{"wrapS", kWraps[static_cast<std::size_t>(texture.wrap_s)]},
                                         {"wrapT", kWraps[static_cast<std::size_t>(texture.wrap_t)]}});
        const std::size_t last = document_["images"].size() - 1;
        document_["textures"].push_back({{"source", last}, {"sampler", last}});
        return static_cast<int>(last);
    }

    void add(const Mesh& mesh) {
        const std::size_t count = mesh.positions.size();
        json attributes = {{"POSITION", accessor(mesh.positions, count, kFloat, "VEC3")}};
        glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        json& positions = document_["accessors"].back();
        positions["min"] = {low.x, low.y, low.z};
        positions["max"] = {high.x, high.y, high.z};
        if (!mesh.normals.empty()) attributes["NORMAL"] = accessor(mesh.normals, count, kFloat, "VEC3");
        if (!mesh.texcoords.empty())
            attributes["TEXCOORD_0"] = accessor(mesh.texcoords, count, kFloat, "VEC2");
        if (!mesh.alphas.empty()) {
            std::vector<glm::vec4> colours;
            for (const float alpha : mesh.alphas) colours.emplace_back(1, 1, 1, alpha);
            attributes["COLOR_0"] = accessor(colours, count, kFloat, "VEC4");
        }
        const int indices = accessor(mesh.triangles, 3 * mesh.triangles.size(), kUnsignedInt, "SCALAR");
        document_["meshes"].push_back(
            {{"primitives",
              {{{"attributes", attributes}, {"indices", indices}, {"material", mesh.material}}}}});
    }

    const Scene& scene_;
    json document_;
    std::string binary_;
};

}  // namespace

void write_glb(const Scene& scene, const std::filesystem::path& path) {
    write_atomically(path, GlbWriter(scene).bytes());
}

}  // namespace aoscore
