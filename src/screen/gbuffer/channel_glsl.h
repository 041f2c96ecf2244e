#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aoscore {

/// The macro that gives a channel's place among the outputs of shaders/gbuffer/scene.frag, where it is drawn:
/// "OUTPUT_LINEAR_DEPTH".
std::string output_macro(std::string_view channel);

/// The text of an include that is generated from the table of image/channels.h:
///   contract/channels.glsl    the samplers u_<input>, and centre_<input>() for the shaded pixel;
///   gbuffer/outputs.glsl      the outputs o_<channel>, and write_channels(), which fills those that are
///   drawn.
/// It returns nothing for any other name.
std::optional<std::string> generated_include(std::string_view name);

}  // namespace aoscore
