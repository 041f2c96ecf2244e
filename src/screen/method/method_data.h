#pragma once

#include "screen/method/method.h"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace aoscore {

/// A method or filter as data, for programs that run its passes elsewhere (WebGL 2): its descriptor, and its
/// assembled shaders in the uniform form, GLSL 3.30 without macros.
///
///   id, label, summary; parameters: [{id, type, default, low, high, choices, unit, length_power,
///   meaning}];
///   presets: every parameter's value by preset; preset_filters: {filter, preset: the filter's} by preset;
///   absolute_presets;
///   passes: [{inputs, scale, source: index into sources}], or processor: what computes it in place of
///   shaders; kernels: [{id, size, scale, largest, tables: [{when: choices by parameter, points: [x, y, z,
///   …]}]}]: `largest` points
///     before `scale`, whose first ones are those of a shorter kernel; size and scale may begin with '@', as
///     in Kernel;
///   depth_mips: {filter, radius: parameter};
///   depth_layers, side_layers, where it reads such an input: each member's value, or '@' and a parameter.
nlohmann::json method_data(const MethodDescriptor& method, std::uint64_t seed);

/// The data that all methods share: screen_vertex, the triangle that fills the picture; derived, by file, the
/// shaders that make inputs from depth, that gather depth layers from kept surfaces (surface_layer.h), and
/// that upsample a result of lower resolution; noise_4x4, four numbers a texel, row by row; depth_mip_levels;
/// macros, those of a plain pass at full resolution; layer_samplings, the macro of each sampling of depth
/// layers that kept surfaces serve; seed.
nlohmann::json contract_data(std::uint64_t seed);

}  // namespace aoscore
