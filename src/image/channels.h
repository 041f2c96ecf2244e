#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace aoscore {

/// The kind of values that a channel holds.
enum class ChannelForm {
    number,     ///< one float
    direction,  ///< three floats: a unit vector in view space
    colour      ///< three floats: linear RGB
};

/// One named picture of a G-buffer: a row of the one table that the rasteriser, the shaders' declarations,
/// the image files and the page are fed from. A new channel is a new row.
struct Channel {
    std::string_view id;  ///< its name in descriptors; the sampler is u_<id>
    ChannelForm form;
    std::string_view meaning;  ///< a sentence with unit and range
    /// Names of the channels in EXR files, one a value.
    std::vector<std::string_view> exr_names;
    /// The GLSL expression that shaders/gbuffer/scene.frag writes; empty for the depth buffer itself.
    std::string_view glsl_value;
    /// The value where nothing is drawn; the camera's far plane where `background_is_far`.
    std::array<float, 4> background{};
    bool background_is_far = false;
    bool always_drawn = false;  ///< whether a method asks for it or not
    bool on_page = false;       ///< the page holds it, so that methods run there; only numbers and directions

    std::size_t values() const { return form == ChannelForm::number ? 1 : 3; }
};

/// All channels, in the order of the rasteriser's outputs.
const std::vector<Channel>& gbuffer_channels();

/// An input of passes that the rasteriser does not draw: it is made from depth, by the program, or by the
/// pass before.
struct MadeInput {
    std::string_view id;
    std::string_view meaning;
    bool is_direction = false;  ///< three values; a pass reads the shaded pixel's by centre_<id>()
    bool filters_only = false;  ///< declared by contract/filter_pass.glsl
    /// It holds several depths a texel, drawn from the scene's triangles; contract/depth_layers.glsl or
    /// contract/side_cameras.glsl declares it.
    bool layered = false;
};
const std::vector<MadeInput>& made_inputs();

}  // namespace aoscore
