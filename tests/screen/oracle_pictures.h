#pragma once

#include "core/image.h"
#include "oracle_cases.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <functional>

namespace aoscore::testing {

/// A height field as triangles, wider than the oracle's picture and twice as fine; `footprint_m` is a
/// pixel's.
Scene height_field_scene(const std::function<double(double, double)>& z, double footprint_m);

/// An orthographic camera of formula::kSize pixels square that looks down -z.
CameraFrame oracle_frame(double footprint_m);

/// The mean picture of the case's shader over its seeds, on the current G-buffer.
ImageF mean_over_seeds(ScreenRenderer& renderer, const std::vector<MethodDescriptor>& methods,
                       const formula::Case& c, Precision precision = Precision::full);

/// The point that a pixel sees, from the G-buffer.
oracle::Point point_at(const CameraFrame& frame, const GBufferImages& images, int x, int y);

}  // namespace aoscore::testing
