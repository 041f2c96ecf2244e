#pragma once

#include "scene/camera.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// The perspective camera that looks along `forward` (unit, not parallel to `up`) with this vertical angle of
/// view, and shows all of the points, as large as a picture of this width to height allows. `margin` of half
/// the picture stays free on every side. Near and far are not set.
///
/// The fit is exact: each side of the picture is a plane through the camera, which the outermost point along
/// its normal must touch; across and upwards that gives a least distance each, and the larger one holds.
Camera fit_outline(const std::vector<glm::dvec3>& points, const glm::dvec3& forward, const glm::dvec3& up,
                   double fovy_rad, double aspect, double margin);

}  // namespace aoscore
