#pragma once

#include "core/image.h"
#include "reference/truth.h"
#include "screen/screen.h"

namespace aoscore {

/// Ray-traced ambient occlusion of frames in real time: so few rays a pixel that a filter must follow. No
/// shader draws it: the ray tracer's picture takes the place of an AO pass, and is filtered and measured like
/// all others. It is not among the methods, and has no time of its own, since rays on a processor say nothing
/// about a graphics card's.
inline constexpr const char* kFewRays = "ray-traced";

/// Its parameters: "rays" a pixel, and "radius", metres.
MethodDescriptor few_rays_descriptor();

bool is_few_rays(const MethodRequest& request);

/// Traces its picture of visibility, 1 where there is no surface. The rays share nothing with those of a
/// truth of the same seed.
ImageF trace_few_rays(const ReferenceScene& reference, const CameraFrame& frame,
                      const MethodRequest& request);

}  // namespace aoscore
