#include "scene/gltf/materials.h"

#include "core/error.h"
#include "image/image_decoder.h"
#include "scene/gltf/texture_extensions.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace aoscore::gltf {
namespace {

constexpr float kBlendCutoff = 0.5f;

Texture::Wrap wrap_of(int gltf_wrap) {
    switch (gltf_wrap) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Texture::Wrap::clamp_to_edge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Texture::Wrap::mirrored_repeat;
        default:
            return Texture::Wrap::repeat;
    }
}

/// The image of a texture: that of WebP, which is decoded; else glTF's own; else another extension's, to be
/// named in a warning.
int image_of(const tinygltf::Texture& texture) {
    const auto source = [&](std::string_view extension) {
        const auto found = texture.extensions.find(std::string(extension));
        return found == texture.extensions.end() ? -1 : found->second.Get("source").GetNumberAsInt();
    };
    if (const int webp = source(kImageExtensions.front()); webp >= 0) return webp;
    if (texture.source >= 0) return texture.source;
    for (const std::string_view extension : kImageExtensions) {
        if (const int other = source(extension); other >= 0) return other;
    }
    return -1;
}

/// Decodes the textures of a document as they are asked for, each once.
class TextureLoader {
  public:
    explicit TextureLoader(Document& document) : document_(document) {}

    /// The index into textures(), or nothing (with a warning) when its image cannot be read.
    std::optional<int> load(int texture_index, const std::string& consequence) {
        const tinygltf::Texture& texture = document_.model->textures[static_cast<std::size_t>(texture_index)];
        const int image = image_of(texture);
        if (image < 0) {
            document_.warn(fmt::format("textures[{}] has no image: {}", texture_index, consequence));
            return std::nullopt;
        }
        Texture::Wrap wrap_s = Texture::Wrap::repeat, wrap_t = Texture::Wrap::repeat;
        if (texture.sampler >= 0) {
            const tinygltf::Sampler& sampler =
                document_.model->samplers[static_cast<std::size_t>(texture.sampler)];
            wrap_s = wrap_of(sampler.wrapS);
            wrap_t = wrap_of(sampler.wrapT);
        }
        const auto [entry, is_new] = loaded_.try_emplace({image, wrap_s, wrap_t}, std::nullopt);
        if (is_new) {
            std::string reason;
            if (auto texels = decode(image, reason)) {
                entry->second = static_cast<int>(textures_.size());
                textures_.push_back({std::move(*texels), wrap_s, wrap_t});
            } else {
                document_.warn(fmt::format("images[{}] {}: {}", image, reason, consequence));
            }
        }
        return entry->second;
    }

    const std::vector<Texture>& textures() const { return textures_; }
    std::vector<Texture> take() { return std::move(textures_); }

  private:
    std::optional<Image<glm::u8vec4>> decode(int image, std::string& reason) {
        const ImageSource& source = document_.images[static_cast<std::size_t>(image)];
        const std::string place = fmt::format("{}: images[{}].uri", document_.where, image);
        if (source.buffer_view >= 0) {
            return decode_image(document_.view_bytes(source.buffer_view), document_.budget, reason);
        }
        std::string bytes;
        try {
            bytes = is_data_uri(source.uri) ? decode_data_uri(source.uri, place)
                                            : document_.folder.read(source.uri, place);
        } catch (const Error&) {
            reason = "is not there or cannot be read";
            return std::nullopt;
        }
        return decode_image(bytes, document_.budget, reason);
    }

    Document& document_;
    std::map<std::tuple<int, Texture::Wrap, Texture::Wrap>, std::optional<int>> loaded_;
    std::vector<Texture> textures_;
};

double number_in(const tinygltf::Value& object, const char* key, int i, double fallback) {
    if (!object.Has(key) || object.Get(key).ArrayLen() <= static_cast<std::size_t>(i)) return fallback;
    return object.Get(key).Get(i).GetNumberAsDouble();
}

/// Applies KHR_texture_transform: scale, then a rotation counter-clockwise in the image as shown (v runs
/// down), then offset.
TexcoordSource texcoord_source(const tinygltf::TextureInfo& info) {
    TexcoordSource source{true, fmt::format("TEXCOORD_{}", info.texCoord), glm::dmat3(1.0)};
    const auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end()) return source;
    const tinygltf::Value& transform = found->second;
    if (transform.Has("texCoord")) {
        source.attribute = fmt::format("TEXCOORD_{}", transform.Get("texCoord").GetNumberAsInt());
    }
    const double angle = transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double scale_u = number_in(transform, "scale", 0, 1), scale_v = number_in(transform, "scale", 1, 1);
    source.uv_from_texcoord = {
        glm::dvec3(c * scale_u, -s * scale_u, 0), glm::dvec3(s * scale_v, c * scale_v, 0),
        glm::dvec3(number_in(transform, "offset", 0, 0), number_in(transform, "offset", 1, 0), 1)};
    return source;
}

float cutoff_of(const tinygltf::Material& material) {
    if (material.alphaMode == "MASK") return std::max(static_cast<float>(material.alphaCutoff), 0.0f);
    return material.alphaMode == "BLEND" ? kBlendCutoff : 0.0f;
}

struct BaseColor {
    glm::vec4 factor{1};
    tinygltf::TextureInfo texture;
};

/// The diffuse colour of the specular-glossiness model, which replaces the base colour (Khronos Group,
/// KHR_materials_pbrSpecularGlossiness, best practices).
BaseColor diffuse_of(const tinygltf::Value& model) {
    BaseColor result;
    for (int c = 0; c < 4; ++c)
        result.factor[c] = static_cast<float>(number_in(model, "diffuseFactor", c, 1));
    if (!model.Has("diffuseTexture")) return result;
    const tinygltf::Value& info = model.Get("diffuseTexture");
    result.texture.index = info.Get("index").GetNumberAsInt();
    if (info.Has("texCoord")) result.texture.texCoord = info.Get("texCoord").GetNumberAsInt();
    if (info.Has("extensions")) {
        const tinygltf::Value& all = info.Get("extensions");
        for (const std::string& name : all.Keys()) result.texture.extensions[name] = all.Get(name);
    }
    return result;
}

BaseColor base_color_of(const tinygltf::Material& material) {
    BaseColor result;
    const auto specular = material.extensions.find("KHR_materials_pbrSpecularGlossiness");
    if (specular != material.extensions.end()) {
        result = diffuse_of(specular->second);
    } else {
        const auto& pbr = material.pbrMetallicRoughness;
        for (int c = 0; c < 4; ++c)
            result.factor[c] = static_cast<float>(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
        result.texture = pbr.baseColorTexture;
    }
    result.factor = glm::clamp(result.factor, glm::vec4(0), glm::vec4(1));
    return result;
}

bool is_cut(const Document& document, int material) {
    const auto& all = document.model->materials;
    return material >= 0 && static_cast<std::size_t>(material) < all.size() &&
           cutoff_of(all[static_cast<std::size_t>(material)]) > 0;
}

/// Warns of variants with cut-outs: primitives keep their own materials, and a variant may have other holes.
void warn_of_cut_variants(Document& document) {
    for (const tinygltf::Mesh& mesh : document.model->meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const auto variants = primitive.extensions.find("KHR_materials_variants");
            if (variants == primitive.extensions.end() || !variants->second.Has("mappings")) continue;
            const tinygltf::Value& mappings = variants->second.Get("mappings");
            for (std::size_t i = 0; i < mappings.ArrayLen(); ++i) {
                const tinygltf::Value& mapping = mappings.Get(static_cast<int>(i));
                const int other = mapping.Has("material") ? mapping.Get("material").GetNumberAsInt() : -1;
                if (!is_cut(document, primitive.material) && !is_cut(document, other)) continue;
                document.warn(
                    "variants (KHR_materials_variants) are not chosen: primitives have their own "
                    "materials, and a variant may cut other holes");
                return;
            }
        }
    }
}

}  // namespace

MaterialTable read_materials(Document& document, bool albedo) {
    warn_of_cut_variants(document);
    MaterialTable table;
    TextureLoader loader(document);
    const std::vector<tinygltf::Material>& sources = document.model->materials;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const tinygltf::Material& source = sources[i];
        const BaseColor color = base_color_of(source);
        Material material;
        material.name = source.name.empty() ? fmt::format("materials[{}]", i) : source.name;
        material.base_color = color.factor;
        material.alpha_cutoff = cutoff_of(source);
        TexcoordSource texcoords;
        if (color.texture.index >= 0 && (material.is_cutout() || albedo)) {
            const std::string consequence = fmt::format(
                "materials[{}] is drawn {}", i, material.is_cutout() ? "solid" : "without its texture");
            if (const auto texture = loader.load(color.texture.index, consequence)) {
                material.texture = *texture;
                texcoords = texcoord_source(color.texture);
            } else {
                material.alpha_cutoff = 0;
            }
        }
        table.materials.push_back(std::move(material));
        table.texcoords.push_back(std::move(texcoords));
    }
    table.materials.push_back(Material{.name = "default"});
    table.texcoords.emplace_back();
    table.textures = loader.take();
    return table;
}

}  // namespace aoscore::gltf
