#pragma once

#include "core/image.h"
#include "screen/screen.h"

// This is a file of its own, because the code of images is the code that the linker takes for it
// (aoscore_code_digests() in CMakeLists.txt).
namespace aoscore {

/// Draws a method's image on the renderer's current G-buffer.
MethodOutput draw_image(ScreenRenderer& renderer, const MethodRequest& request);

/// Counts the texture fetches of the request's AO pass, as a mean over the `valid` pixels.
double fetches_per_pixel(ScreenRenderer& renderer, const MethodRequest& request, const Mask& valid);

}  // namespace aoscore
