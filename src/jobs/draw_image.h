#pragma once

#include "core/image.h"
#include "screen/screen.h"

// A file of its own: the code of images is what the linker takes for it (aoscore_code_digests() in
// CMakeLists.txt).
namespace aoscore {

/// What a method shows on the renderer's current G-buffer.
MethodOutput draw_image(ScreenRenderer& renderer, const MethodRequest& request);

/// Texture fetches of the request's AO pass, mean over the `valid` pixels.
double fetches_per_pixel(ScreenRenderer& renderer, const MethodRequest& request, const Mask& valid);

}  // namespace aoscore
