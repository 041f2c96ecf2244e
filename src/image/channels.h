#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace aoscore {

/// What the values of a channel are.
enum class ChannelForm {
    number,     ///< one float
    direction,  ///< three: a unit vector in view space
    colour      ///< three: linear RGB
};

/// One named picture of a G-buffer: a row of the one table that the rasteriser, the shaders' declarations,
/// the image files and the page are fed from. A new channel is a new row.
struct Channel {
    std::string_view id;  ///< what descriptors list; the sampler is u_<id>
    ChannelForm form;
    std::string_view meaning;  ///< with unit and range
    /// One name for each value, as EXR files have them.
    std::vector<std::string_view> exr_names;
    /// What shaders/gbuffer/scene.frag writes, as a GLSL expression; empty for the depth buffer itself.
    std::string_view glsl_value;
    /// What stays where nothing is drawn; the camera's far plane where `background_is_far`.
    std::array<float, 4> background{};
    bool background_is_far = false;
    bool always_drawn = false;  ///< whether asked for or not
    bool on_page = false;       ///< kept in the page, so that methods run there; numbers and directions alone

    std::size_t values() const { return form == ChannelForm::number ? 1 : 3; }
};

/// In the order of the rasteriser's outputs.
const std::vector<Channel>& gbuffer_channels();

/// An input of passes that no rasteriser draws: made from depth, by the program, or by the pass before.
struct MadeInput {
    std::string_view id;
    std::string_view meaning;
    bool is_direction = false;  ///< three values, of which a pass reads the shaded pixel's by centre_<id>()
    bool filters_only = false;  ///< declared by contract/filter_pass.glsl
    /// Several depths a texel, drawn from the scene's triangles; declared by contract/depth_layers.glsl.
    bool layered = false;
};
const std::vector<MadeInput>& made_inputs();

}  // namespace aoscore
