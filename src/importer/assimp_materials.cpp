#include "importer/assimp_materials.h"

#include <assimp/material.h>
#include <assimp/texture.h>
#include <fmt/format.h>

#include <cmath>

namespace aoscore::importer {
namespace {

Texture::Wrap wrap_of(const aiMaterial& material, aiTextureType type, bool along_u) {
    int mode = aiTextureMapMode_Wrap;
    if (along_u) {
        material.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), mode);
    } else {
        material.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), mode);
    }
    if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) return Texture::Wrap::clamp_to_edge;
    return mode == aiTextureMapMode_Mirror ? Texture::Wrap::mirrored_repeat : Texture::Wrap::repeat;
}

TextureUse texture_use(const aiMaterial& material, aiTextureType type) {
    TextureUse use;
    aiString name;
    if (material.Get(AI_MATKEY_TEXTURE(type, 0), name) != aiReturn_SUCCESS) return use;
    use.name = name.C_Str();
    use.wrap_s = wrap_of(material, type, true);
    use.wrap_t = wrap_of(material, type, false);
    aiUVTransform transform;
    if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS) {
        use.scale = {transform.mScaling.x, transform.mScaling.y};
        use.offset = {transform.mTranslation.x, transform.mTranslation.y};
    }
    int set = 0;
    if (material.Get(AI_MATKEY_UVWSRC(type, 0), set) == aiReturn_SUCCESS && set > 0)
        use.texcoord_set = static_cast<unsigned>(set);
    return use;
}

/// FBX's transparency is TransparentColor times TransparencyFactor; Assimp's opacity forgets the factor,
/// which many files set to 0 beside a white colour.
float opacity_of(const aiMaterial& material) {
    float opacity = 1, factor = 1;
    aiColor3D transparent(0, 0, 0);
    material.Get(AI_MATKEY_OPACITY, opacity);
    const bool has_color = material.Get(AI_MATKEY_COLOR_TRANSPARENT, transparent) == aiReturn_SUCCESS;
    const bool has_factor = material.Get(AI_MATKEY_TRANSPARENCYFACTOR, factor) == aiReturn_SUCCESS;
    if (!has_color || !has_factor) return opacity;
    constexpr float kSame = 1e-4f;
    const float mean = (transparent.r + transparent.g + transparent.b) / 3;
    const bool is_from_color = std::abs(opacity - (1 - mean)) < kSame;
    return is_from_color ? 1 - mean * factor : opacity;
}

MaterialSource source_of(const aiMaterial& material) {
    MaterialSource source;
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) source.name = name.C_Str();
    aiColor3D color(1, 1, 1);
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS)
        source.color = {color.r, color.g, color.b};
    source.color_map = texture_use(material, aiTextureType_DIFFUSE);
    if (source.color_map.name.empty()) source.color_map = texture_use(material, aiTextureType_BASE_COLOR);
    source.opacity_map = texture_use(material, aiTextureType_OPACITY);
    source.opacity = source.opacity_map.name.empty() ? opacity_of(material) : 1;
    return source;
}

}  // namespace

AssimpMaterials::AssimpMaterials(ImportJob& job, const aiScene& source)
    : job_(job), source_(source), materials_(job) {
    materials_.embedded = [&source](const std::string& name) -> std::optional<std::string_view> {
        const aiTexture* texture = source.GetEmbeddedTexture(name.c_str());
        // A height of 0 marks an image file, whose width is its number of bytes.
        if (texture == nullptr || texture->mHeight != 0) return std::nullopt;
        return std::string_view(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
    };
}

const AssimpMaterials::Used& AssimpMaterials::use(unsigned material) {
    const auto [entry, is_new] = used_.try_emplace(material);
    if (is_new) {
        MaterialSource source;
        if (material < source_.mNumMaterials) source = source_of(*source_.mMaterials[material]);
        entry->second.material = static_cast<int>(job_.plain.scene.materials.size());
        entry->second.texture = materials_.add(source);
    }
    return entry->second;
}

}  // namespace aoscore::importer
