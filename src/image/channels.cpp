#include "image/channels.h"

namespace aoscore {

// A normal of the background faces the camera, so that a method which reads one stays finite.
const std::vector<Channel>& gbuffer_channels() {
    static const std::vector<Channel> table = {
        {.id = "linear_depth",
         .form = ChannelForm::number,
         .meaning = "view depth, metres, positive; u_far on background",
         .exr_names = {"Z"},
         .glsl_value = "linear_depth()",
         .background_is_far = true,
         .always_drawn = true,
         .on_page = true},
        {.id = "hardware_depth",
         .form = ChannelForm::number,
         .meaning = "OpenGL window depth in [0,1]",
         .exr_names = {"depth.Z"},
         .glsl_value = "",
         .background = {1, 0, 0, 0},
         .always_drawn = true,
         .on_page = true},
        {.id = "normal_geometric",
         .form = ChannelForm::direction,
         .meaning = "of the triangle: view space, unit, turned to the camera",
         .exr_names = {"N.X", "N.Y", "N.Z"},
         .glsl_value = "vec4(geometric_normal(), 0.0)",
         .background = {0, 0, 1, 0},
         .on_page = true},
        {.id = "normal_smooth",
         .form = ChannelForm::direction,
         .meaning = "interpolated: view space, unit, on the geometric normal's side",
         .exr_names = {"Ns.X", "Ns.Y", "Ns.Z"},
         .glsl_value = "vec4(smooth_normal(), 0.0)",
         .background = {0, 0, 1, 0},
         .on_page = true},
        {.id = "albedo",
         .form = ChannelForm::colour,
         .meaning = "linear RGB",
         .exr_names = {"albedo.R", "albedo.G", "albedo.B"},
         .glsl_value = "vec4(albedo_at(v_texcoord), 1.0)"},
    };
    return table;
}

const std::vector<MadeInput>& made_inputs() {
    static const std::vector<MadeInput> table = {
        {.id = "normal_from_depth",
         .meaning = "view space, unit, from differences of depth",
         .is_direction = true},
        {.id = "normal_from_depth_accurate",
         .meaning = "the same, from the better side of each pixel",
         .is_direction = true},
        {.id = "depth_mips",
         .meaning = "linear depth in 6 levels; the descriptor's depth_mips says how they are made"},
        {.id = "depth_layers",
         .meaning = "several view depths a texel, metres, u_far where there is none; the descriptor's "
                    "depth_layers says how they are gathered",
         .layered = true},
        {.id = "side_layers",
         .meaning =
             "the same of further cameras beside the view's own; the descriptor's side_layers says where "
             "they stand",
         .layered = true},
        {.id = "noise_4x4", .meaning = "four numbers in [0,1) a texel, each a permutation of (i + ½)/16"},
        {.id = "coarser", .meaning = "visibility of the pass before, at 1/COARSER_SCALE"},
        {.id = "visibility", .meaning = "to be filtered or lit", .filters_only = true},
    };
    return table;
}

}  // namespace aoscore
