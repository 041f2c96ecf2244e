#include "screen/gbuffer/channel_glsl.h"

#include "image/channels.h"

#include <fmt/format.h>

#include <cctype>

namespace aoscore {
namespace {

std::string sampler(std::string_view id, std::string_view meaning) {
    return fmt::format("uniform sampler2D u_{};  // {}\n", id, meaning);
}

std::string centre(std::string_view id, bool is_number) {
    return fmt::format("{} centre_{}() {{ return picture_texel(u_{}, vec2(centre_texel())).{}; }}\n",
                       is_number ? "float" : "vec3", id, id, is_number ? "r" : "xyz");
}

std::string declared_inputs() {
    std::string samplers, centres;
    for (const Channel& channel : gbuffer_channels()) {
        samplers += sampler(channel.id, channel.meaning);
        centres += centre(channel.id, channel.form == ChannelForm::number);
    }
    for (const MadeInput& input : made_inputs()) {
        if (input.filters_only || input.layered) continue;
        samplers += sampler(input.id, input.meaning);
        if (input.is_direction) centres += centre(input.id, false);
    }
    return samplers + centres;
}

std::string declared_outputs() {
    std::string outputs, writes;
    for (const Channel& channel : gbuffer_channels()) {
        if (channel.glsl_value.empty()) continue;
        const std::string macro = output_macro(channel.id);
        const std::string_view type = channel.form == ChannelForm::number ? "float" : "vec4";
        outputs += fmt::format("#ifdef {0}\nlayout(location = {0}) out {1} o_{2};\n#endif\n", macro, type,
                               channel.id);
        writes += fmt::format("#ifdef {}\n    o_{} = {};\n#endif\n", macro, channel.id, channel.glsl_value);
    }
    return outputs + "void write_channels() {\n" + writes + "}\n";
}

}  // namespace

std::string output_macro(std::string_view channel) {
    std::string macro = "OUTPUT_";
    for (const char c : channel) macro += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return macro;
}

std::optional<std::string> generated_include(std::string_view name) {
    if (name == "contract/channels.glsl") return declared_inputs();
    if (name == "gbuffer/outputs.glsl") return declared_outputs();
    return std::nullopt;
}

}  // namespace aoscore
