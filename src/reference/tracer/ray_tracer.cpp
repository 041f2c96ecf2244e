#include "reference/tracer/ray_tracer.h"

#include "reference/tracer/embree/embree_scene.h"

namespace aoscore {

std::unique_ptr<RayTracer> new_ray_tracer(const Scene& scene, const TraceBuild& build,
                                          const std::vector<char>& wanted) {
    return std::make_unique<EmbreeScene>(scene, build, wanted);
}

}  // namespace aoscore
