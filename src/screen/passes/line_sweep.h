#pragma once

#include "screen/passes/processors.h"

namespace aoscore {

/// Visibility without a radius, by sweeping lines over the picture: the occluders behind a pixel on its line
/// form a convex hull, kept on a stack, whose tangent is the horizon (Timonen, Line-Sweep Ambient Obscurance,
/// 2013). It takes time linear in the pixels for any distance of occluders, is 1 on background, and the same
/// for any number of threads. Reads the parameters "directions" and "edge".
ImageF line_sweep(const ProcessorInput& input, const ParameterValues& parameters);

/// The number of texture fetches a pixel: a sweep reads the two pixels beside its line at every step.
double line_sweep_fetches(const ParameterValues& parameters);

}  // namespace aoscore
