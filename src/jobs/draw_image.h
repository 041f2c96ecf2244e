#pragma once

#include "core/image.h"
#include "screen/screen.h"

namespace aoscore {

/// What a method shows on the renderer's current G-buffer.
MethodOutput draw_image(ScreenRenderer& renderer, const MethodRequest& request);

/// Texture fetches of the request's AO pass, mean over the `valid` pixels.
double fetches_per_pixel(ScreenRenderer& renderer, const MethodRequest& request, const Mask& valid);

}  // namespace aoscore
