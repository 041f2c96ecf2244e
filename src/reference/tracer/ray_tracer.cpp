#include "reference/tracer/ray_tracer.h"

#include "reference/tracer/embree/embree_scene.h"

namespace aoscore {

TreeEffort tree_effort(std::uint64_t triangles, double rays) {
    constexpr double kRaysPerTriangle = 16;
    return rays < kRaysPerTriangle * static_cast<double>(triangles) ? TreeEffort::quick
                                                                    : TreeEffort::thorough;
}

std::unique_ptr<RayTracer> new_ray_tracer(const Scene& scene, const TraceBuild& build,
                                          const std::vector<char>& wanted, double rays) {
    return std::make_unique<EmbreeScene>(scene, build, wanted, rays);
}

}  // namespace aoscore
