#pragma once

#include "scene/camera.h"
#include "screen/method/side_layers.h"
#include "screen/screen.h"

#include <vector>

namespace aoscore {

class ShaderProgram;

/// The side cameras of a view, mirrored where its randomness is. Without an offset to the right they look
/// straight ahead, and without any offset the first is the view's camera to the bit. Throws usage_error where
/// the point that they look at is not in front of them.
std::vector<CameraFrame> side_cameras(const CameraFrame& main, const SideLayers& side, Mirror mirror);

/// Sets the uniforms of shaders/contract/side_cameras.glsl in a program that is in use.
void set_side_uniforms(const ShaderProgram& program, const CameraFrame& main,
                       const std::vector<CameraFrame>& cameras);

}  // namespace aoscore
