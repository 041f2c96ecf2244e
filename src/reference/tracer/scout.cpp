#include "reference/tracer/scout.h"

#include "core/sampling.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/tracer/ray_tracer.h"

namespace aoscore {
namespace {

/// Point `index` of the Sobol sequence for directions, scrambled for this pixel.
glm::vec3 direction_of(std::uint32_t index, std::uint64_t pixel) {
    const std::uint64_t seed = mix_bits(pixel);
    const float u = unit_interval(owen_scramble_reversed(index, static_cast<std::uint32_t>(seed)));
    const float v = unit_interval(
        owen_scramble_reversed(sobol_y_reversed(index), static_cast<std::uint32_t>(seed >> 32)));
    return cosine_hemisphere(u, v);
}

}  // namespace

struct Scout::Impl {
    explicit Impl(const Scene& scene) : tracer(new_ray_tracer(scene, {})) {}

    double visibility(const SurfaceHit& hit, double radius_m, int rays, std::uint64_t pixel) const {
        const glm::vec3 origin(hit.position + hit.offset_m * hit.normal);
        const glm::mat3 frame(frame_about(hit.normal));
        int open = 0;
        for (int i = 0; i < rays; ++i) {
            const glm::vec3 d = frame * direction_of(static_cast<std::uint32_t>(i), pixel);
            open += !tracer->occluded(TraceRay{origin, d, 0, static_cast<float>(radius_m)});
        }
        return rays > 0 ? static_cast<double>(open) / rays : 1;
    }

    std::unique_ptr<RayTracer> tracer;
};

Scout::Scout(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Scout::~Scout() = default;
Scout::Scout(Scout&&) noexcept = default;
Scout& Scout::operator=(Scout&&) noexcept = default;

Sight Scout::first_surface(const glm::dvec3& from, const glm::dvec3& direction) const {
    const FlushDenormals flush;
    SurfaceHit hit;
    const double endless = std::numeric_limits<float>::infinity();
    if (!impl_->tracer->first_hit({from, direction}, 0, endless, hit)) return {};
    return {hit.depth, hit.front};
}

Glance Scout::look(const CameraFrame& frame, double radius_m, int rays) const {
    const FlushDenormals flush;
    Glance glance;
    SurfaceHit hit;
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            const std::uint64_t pixel = glance.pixels++;
            const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
            if (!impl_->tracer->first_hit(ray, frame.camera().near, frame.camera().far, hit)) continue;
            glance.points.push_back({hit.position + impl_->tracer->centre(), hit.depth,
                                     impl_->visibility(hit, radius_m, rays, pixel), hit.front});
        }
    }
    return glance;
}

}  // namespace aoscore
