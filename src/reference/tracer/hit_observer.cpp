#include "reference/tracer/hit_observer.h"

#include "reference/estimate/falloff.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kHiddenDepthPart = 0.01;
constexpr double kGrazingCosine = 0.1;
/// Surfaces that a ray may pass on its way to a visible one.
constexpr int kMostLayers = 64;
/// By how much of its distance a ray steps over a surface that it has met.
constexpr float kStep = 1e-5f;

}  // namespace

Cause CauseJudge::judge(const glm::dvec3& position, const glm::dvec3& normal) const {
    const Camera& camera = frame_.camera();
    const glm::dvec3 view(frame_.view_from_world() * glm::dvec4(position + scene_.centre(), 1));
    const double depth = -view.z;
    if (!(depth >= camera.near && depth <= camera.far)) return Cause::outside;
    const glm::dvec3 place = frame_.project(view);
    if (!(place.x >= 0 && place.x < frame_.width() && place.y >= 0 && place.y < frame_.height())) {
        return Cause::outside;
    }
    const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
    const double shown = hits_.depth.at(x, y);
    const double tolerance = std::max(kHiddenDepthPart * shown, frame_.pixel_footprint(shown));
    if (hits_.surface.at(x, y) != 0 && depth > shown + tolerance) return Cause::hidden;
    const glm::dvec3 sight = camera.projection == Camera::Projection::perspective
                                 ? glm::normalize(position + scene_.centre() - camera.position)
                                 : glm::normalize(camera.target - camera.position);
    return std::abs(glm::dot(normal, sight)) < kGrazingCosine ? Cause::grazing : Cause::visible;
}

double HitObserver::first_visible(const ObservedRay& ray, Cause nearest) const {
    if (nearest == Cause::visible) return occlusion_at(query_, ray.distance_m);
    TraceRay rest{ray.origin, ray.direction, 0, static_cast<float>(query_.radius_m)};
    TraceHit next{static_cast<float>(ray.distance_m)};
    for (int layer = 0; layer < kMostLayers; ++layer) {
        rest.from_m = next.distance_m * (1 + kStep);
        if (!scene_.nearest(rest, next)) return 0;
        const glm::dvec3 position =
            glm::dvec3(ray.origin) + static_cast<double>(next.distance_m) * glm::dvec3(ray.direction);
        if (judge_.judge(position, next.normal) == Cause::visible) return occlusion_at(query_, next.distance_m);
    }
    return 0;
}

void HitObserver::observe(std::size_t source, const ObservedRay& ray) {
    Sums& sums = sums_[source];
    const double dark = ray.hit ? occlusion_at(query_, ray.distance_m) : 0;
    if (dark <= 0) return;
    const Cause cause =
        judge_.judge(glm::dvec3(ray.origin) + ray.distance_m * glm::dvec3(ray.direction), ray.normal);
    sums.by_cause[static_cast<std::size_t>(cause)] += dark;
    if (extras_.one_layer_bound) sums.one_layer += first_visible(ray, cause);
}

}  // namespace aoscore
