#include "scene/gltf/asset_folder.h"
#include "scene/gltf/structure.h"
#include "scene/gltf/texture_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace aoscore::gltf {
namespace {

void check_base_color_texture(CheckedObject& info, const Counts& counts) {
    info.required_index("index", counts.textures);
    info.integer("texCoord", 0, 255);
    info.object("extensions", [](CheckedObject& extensions) {
        extensions.object("KHR_texture_transform", [](CheckedObject& transform) {
            transform.numbers("offset", 2);
            transform.numbers("scale", 2);
            transform.number("rotation");
            transform.integer("texCoord", 0, 255);
        });
    });
}

/// Checks a texture that occlusion never needs, and takes it out of the JSON that tinygltf sees.
void check_unread_texture(CheckedObject& owner, const char* key, const Counts& counts) {
    owner.object(key, [&](CheckedObject& info) {
        info.required_index("index", counts.textures);
        info.integer("texCoord", 0, 255);
        info.number("scale");
        info.number("strength");
    });
    owner.erase(key);
}

/// Checks a factor, which exporters may have rounded: 1.00000012 is a 1. It is clamped where it is used.
void check_factor(CheckedObject& owner, const char* key, std::vector<std::string>& warnings) {
    for (const double v : owner.numbers(key, 4)) {
        if (v >= 0 && v <= 1) continue;
        warnings.push_back(
            fmt::format("{} holds {}: clamped to 0 to 1", Place(owner.place(), key).text(), v));
    }
}

void check_material(CheckedObject& material, const Counts& counts, std::vector<std::string>& warnings) {
    const std::string mode = material.text("alphaMode");
    if (!mode.empty() && mode != "OPAQUE" && mode != "MASK" && mode != "BLEND") {
        material.fail("alphaMode", "is unknown", "OPAQUE, MASK, BLEND");
    }
    const auto cutoff = material.number("alphaCutoff");
    if (cutoff && *cutoff < 0)
        warnings.push_back(
            fmt::format("{} is {}: nothing is cut", Place(material.place(), "alphaCutoff").text(), *cutoff));
    material.object("pbrMetallicRoughness", [&](CheckedObject& pbr) {
        check_factor(pbr, "baseColorFactor", warnings);
        pbr.object("baseColorTexture", [&](CheckedObject& info) { check_base_color_texture(info, counts); });
        check_unread_texture(pbr, "metallicRoughnessTexture", counts);
    });
    material.object("extensions", [&](CheckedObject& extensions) {
        extensions.object("KHR_materials_pbrSpecularGlossiness", [&](CheckedObject& specular) {
            check_factor(specular, "diffuseFactor", warnings);
            specular.object("diffuseTexture",
                            [&](CheckedObject& info) { check_base_color_texture(info, counts); });
        });
    });
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
        check_unread_texture(material, key, counts);
    }
    material.erase("emissiveFactor");
}

}  // namespace

void check_materials_and_textures(CheckedObject& root, const Counts& counts,
                                  std::vector<std::string>& warnings) {
    root.objects("materials",
                 [&](CheckedObject& material, std::size_t) { check_material(material, counts, warnings); });
    root.objects("textures", [&](CheckedObject& texture, std::size_t) {
        texture.index("source", counts.images);
        texture.index("sampler", counts.samplers);
        texture.object("extensions", [&](CheckedObject& extensions) {
            for (const std::string_view name : kImageExtensions) {
                extensions.object(
                    name, [&](CheckedObject& other) { other.required_index("source", counts.images); });
            }
        });
    });
    root.objects("samplers", [&](CheckedObject& sampler, std::size_t) {
        constexpr std::array<std::int64_t, 3> kWraps = {33071, 33648, 10497};
        for (const char* key : {"wrapS", "wrapT"}) {
            const auto wrap = sampler.integer(key, 0, 0xFFFF);
            if (wrap && std::find(kWraps.begin(), kWraps.end(), *wrap) == kWraps.end()) {
                sampler.fail(key, fmt::format("is {}", *wrap), "33071, 33648, 10497");
            }
        }
        sampler.erase("magFilter");
        sampler.erase("minFilter");
    });
    root.objects("images", [&](CheckedObject& image, std::size_t) {
        image.index("bufferView", counts.buffer_views);
        const std::string uri = image.text("uri");
        if (image.has("uri") == image.has("bufferView")) image.fail("uri", "needs either uri or bufferView");
        if (image.has("uri") && !is_data_uri(uri))
            check_relative_uri(uri, Place(image.place(), "uri").text());
    });
}

}  // namespace aoscore::gltf
