#pragma once

#include <string>
#include <string_view>

namespace aoscore {

/// The kind of content that a channel's name promises.
enum class ChannelMeaning {
    occlusion,  ///< ambient occlusion, whichever way round
    geometry,   ///< properties of surfaces: depth, normals, albedo, masks, alpha, errors
    shading,    ///< pictures of light: beauty, diffuse, shadows
    unknown     ///< the name says nothing
};

/// A channel's name in its parts: "ViewLayer.AO.R" is component R of the layer "ViewLayer.AO", "AO" a layer
/// without a component, "R" one without a name.
struct ChannelName {
    std::string layer, component;

    explicit ChannelName(const std::string& name);
};

/// Decides by the words of the layer's name, in any case and with any separators: "ViewLayer.Ambient
/// Occlusion", "FinalImageAmbientOcclusion" and "VRayExtraTex_AO" are ambient occlusion.
ChannelMeaning meaning_of(const ChannelName& name);

}  // namespace aoscore
