#include "importer/surface_materials.h"

#include "core/error.h"
#include "importer/texture_decoder.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace aoscore::importer {
namespace {

using Texels = Image<glm::u8vec4>;

constexpr float kCutoff = 0.5f;

bool has_alpha(const Texels& image) {
    return std::any_of(image.pixels.begin(), image.pixels.end(),
                       [](const glm::u8vec4& texel) { return texel.a < 255; });
}

std::uint8_t luminance(const glm::u8vec4& texel) {
    constexpr glm::dvec3 kRec709(0.2126, 0.7152, 0.0722);
    return static_cast<std::uint8_t>(std::lround(glm::dot(kRec709, glm::dvec3(texel))));
}

std::uint8_t opacity_of(const glm::u8vec4& texel, char channel, bool image_has_alpha) {
    switch (channel) {
        case 'r':
            return texel.r;
        case 'g':
            return texel.g;
        case 'b':
            return texel.b;
        case 'l':
            return luminance(texel);
        default:
            return image_has_alpha ? texel.a : luminance(texel);
    }
}

/// The colour at the middle of texel (x, y) when the image is resampled to `width` x `height`.
glm::u8vec4 resampled(const Texels& image, int x, int y, int width, int height) {
    const auto column = (2 * std::int64_t{x} + 1) * image.width / (2 * width);
    const auto row = (2 * std::int64_t{y} + 1) * image.height / (2 * height);
    return image.at(static_cast<int>(column), static_cast<int>(row));
}

/// The opacity's texels, with the colours of another image where there is one.
Texels combined(const Texels& opacity, char channel, const Texels* color) {
    const bool alpha = has_alpha(opacity);
    Texels texels(opacity.width, opacity.height, glm::u8vec4(255));
    for (int y = 0; y < texels.height; ++y) {
        for (int x = 0; x < texels.width; ++x) {
            if (color != nullptr) texels.at(x, y) = resampled(*color, x, y, texels.width, texels.height);
            texels.at(x, y).a = opacity_of(opacity.at(x, y), channel, alpha);
        }
    }
    return texels;
}

/// Whether an image's alpha looks like a stencil: nearly all of it is either solid or clear, and there is
/// some of each. An alpha that holds gloss or height does not.
bool is_stencil(const Texels& image) {
    constexpr int kNearlyNothing = 25, kNearlySolid = 230, kHalf = 128;
    constexpr double kNearlyAll = 0.9;
    std::size_t decided = 0, holes = 0;
    for (const glm::u8vec4& texel : image.pixels) {
        decided += texel.a <= kNearlyNothing || texel.a >= kNearlySolid ? 1 : 0;
        holes += texel.a < kHalf ? 1 : 0;
    }
    return holes > 0 && holes < image.size() &&
           static_cast<double>(decided) >= kNearlyAll * static_cast<double>(image.size());
}

float least_alpha(const Texels& image) {
    std::uint8_t least = 255;
    for (const glm::u8vec4& texel : image.pixels) least = std::min(least, texel.a);
    return static_cast<float>(least) / 255.0f;
}

}  // namespace

std::optional<std::string> SurfaceMaterials::bytes_of(const std::string& name) const {
    if (const auto bytes = embedded ? embedded(name) : std::nullopt) return std::string(*bytes);
    return job_.folder.read(name);
}

const Texels* SurfaceMaterials::image(const std::string& name) {
    const auto [entry, is_new] = images_.try_emplace(name);
    if (is_new) {
        if (const std::optional<std::string> bytes = bytes_of(name)) {
            std::string reason;
            entry->second = decode_texture(name, *bytes, budget_, reason);
            if (!entry->second) job_.warn(fmt::format("image {} {}", gltf::printable(name), reason));
        } else {
            missing_.insert(gltf::printable(name));
        }
    }
    return entry->second ? &*entry->second : nullptr;
}

/// Whether an image has an alpha at all, which its first bytes may rule out: most colours are never decoded.
bool SurfaceMaterials::may_cut(const std::string& name) {
    const auto [entry, is_new] = may_cut_.try_emplace(name, false);
    if (is_new) {
        const std::optional<std::string> bytes = bytes_of(name);
        if (!bytes) missing_.insert(gltf::printable(name));
        entry->second = bytes && may_have_alpha(*bytes);
    }
    return entry->second;
}

/// Whether the alpha of the colours cuts holes: many exporters give foliage that and no opacity of its own.
bool SurfaceMaterials::cuts_by_color_alpha(const MaterialSource& source) {
    if (source.color_map.name.empty() || !source.opacity_map.name.empty()) return false;
    if (!may_cut(source.color_map.name)) return false;
    const Texels* color = image(source.color_map.name);
    if (color == nullptr || !has_alpha(*color)) return false;
    const bool cuts = is_stencil(*color);
    const std::string name = gltf::printable(source.color_map.name);
    job_.warn(cuts ? fmt::format("image {}: its alpha cuts holes, though no material says so", name)
                   : fmt::format(
                         "image {}: its alpha is no stencil, and no material says that it cuts: drawn solid",
                         name));
    return cuts;
}

void SurfaceMaterials::finish() {
    if (missing_.empty()) return;
    job_.warn(fmt::format(
        "{} images are not in the scene's folder, such as {}: holes that they would cut are solid",
        missing_.size(), *missing_.begin()));
}

int SurfaceMaterials::add_texture(const TextureUse& use, Texels texels) {
    std::vector<Texture>& textures = job_.plain.scene.textures;
    textures.push_back({std::move(texels), use.wrap_s, use.wrap_t});
    return static_cast<int>(textures.size()) - 1;
}

std::optional<TextureUse> SurfaceMaterials::add(const MaterialSource& source) {
    Material material;
    material.name = gltf::printable(source.name);
    material.base_color =
        glm::vec4(glm::clamp(source.color, 0.0f, 1.0f), std::clamp(source.opacity, 0.0f, 1.0f));
    std::optional<TextureUse> use;
    const bool by_color_alpha = cuts_by_color_alpha(source);
    const TextureUse& opacity_use = by_color_alpha ? source.color_map : source.opacity_map;
    if (const Texels* opacity = opacity_use.name.empty() ? nullptr : image(opacity_use.name)) {
        Texels texels = combined(*opacity, opacity_use.channel,
                                 source.color_map.name.empty() ? nullptr : image(source.color_map.name));
        if (least_alpha(texels) * material.base_color.a < kCutoff) {
            material.alpha_cutoff = kCutoff;
            material.texture = add_texture(opacity_use, std::move(texels));
            use = opacity_use;
        }
    } else if (!opacity_use.name.empty()) {
        job_.warn(fmt::format("material {} is drawn solid: its opacity cannot be read", material.name));
    }
    if (!use && material.base_color.a < kCutoff) {
        material.alpha_cutoff = kCutoff;
        job_.warn(fmt::format("material {} has an opacity of {:.3g}, below {}: its surfaces are left out",
                              material.name, material.base_color.a, kCutoff));
    } else if (!use && job_.albedo && !source.color_map.name.empty()) {
        if (const Texels* color = image(source.color_map.name)) {
            material.texture = add_texture(source.color_map, *color);
            use = source.color_map;
        }
    }
    job_.plain.scene.materials.push_back(std::move(material));
    return use;
}

}  // namespace aoscore::importer
