#pragma once

#include "reference/tracer/ray_batch.h"
#include "reference/tracer/ray_tracer.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace aoscore::testing {

/// Eight by eight points a little above the floor of thicket(), in trace space; point i has the normal
/// `normal_of(i)`, unit.
std::vector<RaySource> tile_points(const RayTracer& scene,
                                   const std::function<glm::dvec3(std::uint64_t)>& normal_of);

}  // namespace aoscore::testing
