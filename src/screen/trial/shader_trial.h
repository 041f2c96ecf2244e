#pragma once

#include "screen/passes/shader_source.h"

#include <string>

namespace aoscore {

/// Compiles a program and draws a few pixels with it in a process of its own, aoscore-shader-trial, which may
/// take 20 s of processor time and 2 GiB of memory: what comes out of it well will not exhaust this process.
/// Whether the shader compiles is not its question. Throws file_error naming `name` where it ends otherwise,
/// interrupted_error on Ctrl-C.
void try_shader(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name);

}  // namespace aoscore
