#pragma once

#include "screen/screen.h"

#include <string>

namespace aoscore {

/// The digest of everything besides the G-buffer's content and this program's code that decides a request's
/// image: the assembled sources of all its passes, its filter's and its lighting's with their parameters,
/// kernels and includes, the shaders that make their inputs, modes and seed. It needs no OpenGL. Throws
/// file_error for a shader that cannot be read.
std::string request_digest(const MethodRequest& request, bool orthographic);

}  // namespace aoscore
