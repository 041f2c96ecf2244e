#include "reference/tracer/open_directions.h"

#include "reference/estimate/falloff.h"

namespace aoscore {

void OpenDirections::observe(std::size_t source, const ObservedRay& ray) {
    const double open = 1 - (ray.hit ? occlusion_at(query_, ray.distance_m) : 0);
    OpenSums& sums = sums_[source];
    sums.open[ray.block] += open;
    for (int axis = 0; axis < 3; ++axis) {
        sums.direction[ray.block][axis] +=
            in_steps(open * static_cast<double>(ray.direction[axis]), OpenSums::kDirectionStep);
    }
}

}  // namespace aoscore
