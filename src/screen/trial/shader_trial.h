#pragma once

#include "screen/passes/shader_source.h"

#include <string>

namespace aoscore {

/// Compiles a program and draws a few pixels with it in a process of its own, aoscore-shader-trial, which may
/// take 20 s of processor time and 2 GiB of memory: a shader that passes will not exhaust this process. It
/// does not matter whether the shader compiles. Throws file_error naming `name` where the trial ends
/// otherwise, interrupted_error on Ctrl-C.
void try_shader(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name);

}  // namespace aoscore
