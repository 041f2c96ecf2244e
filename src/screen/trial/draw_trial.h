#pragma once

#include <string>

namespace aoscore {

/// Compiles the program, and where that succeeds draws a few pixels with it, in a context of its own. Inputs
/// are black, with the far plane behind them, so that everything is shaded. Throws internal_error where
/// OpenGL is out of memory.
void draw_trial(const std::string& vertex, const std::string& fragment);

}  // namespace aoscore
