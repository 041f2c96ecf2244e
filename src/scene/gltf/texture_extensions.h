#pragma once

#include <array>
#include <string_view>

namespace aoscore::gltf {

/// Extensions of a texture that name an image of another format. The first is decoded; the others' images are
/// taken where the texture has no image of glTF's own, and are then named as not decoded.
inline constexpr std::array<std::string_view, 5> kImageExtensions = {
    "EXT_texture_webp", "KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif", "EXT_texture_astc"};

}  // namespace aoscore::gltf
