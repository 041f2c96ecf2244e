#pragma once

#include "core/image.h"
#include "reference/truth.h"
#include "screen/screen.h"

namespace aoscore {

/// Ray-traced ambient occlusion as frames in real time have it: so few rays a pixel that a filter must
/// follow. A contestant that no shader draws: the ray tracer's picture in place of an AO pass, filtered and
/// measured like all others. Not among the methods; it has no time of its own, since rays on a processor say
/// nothing of a graphics card's.
inline constexpr const char* kFewRays = "ray-traced";

/// Its parameters: "rays" a pixel, and "radius", metres.
MethodDescriptor few_rays_descriptor();

bool is_few_rays(const MethodRequest& request);

/// Its picture, visibility, 1 where there is no surface. The rays share nothing with those of a truth of the
/// same seed.
ImageF trace_few_rays(const ReferenceScene& reference, const CameraFrame& frame,
                      const MethodRequest& request);

}  // namespace aoscore
