#include "reference/tile_points.h"

#include "core/sampling.h"

namespace aoscore::testing {

std::vector<RaySource> tile_points(const RayTracer& scene,
                                   const std::function<glm::dvec3(std::uint64_t)>& normal_of) {
    std::vector<RaySource> sources;
    for (std::uint64_t i = 0; i < 64; ++i) {
        const glm::dvec3 place(0.02 * static_cast<double>(i % 8), 1e-3, 0.02 * static_cast<double>(i / 8));
        sources.push_back(
            {glm::vec3(place - scene.centre()), glm::mat3(frame_about(normal_of(i))), mix_bits(i)});
    }
    return sources;
}

}  // namespace aoscore::testing
