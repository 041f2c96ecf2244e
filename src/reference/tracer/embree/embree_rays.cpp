// How EmbreeScene answers for rays and packets; building is in embree_scene.cpp.
#include "reference/tracer/embree/embree_packets.h"
#include "reference/tracer/embree/embree_scene.h"
#include "scene/cofactors.h"

namespace aoscore {
namespace {

RTCRay embree_ray(const TraceRay& ray) {
    return {ray.origin.x,
            ray.origin.y,
            ray.origin.z,
            ray.from_m,
            ray.direction.x,
            ray.direction.y,
            ray.direction.z,
            0,
            ray.reach_m,
            ~0u,
            0,
            0};
}

RTCIntersectContext plain_context() {
    return context_of_packets(false);
}

}  // namespace

bool EmbreeScene::occluded(const TraceRay& ray) const {
    RTCRay query = embree_ray(ray);
    RTCIntersectContext context = plain_context();
    rtcOccluded1(scene_.get(), &context, &query);
    return !(query.tfar >= 0);  // Embree's sign of a hit is -infinity
}

bool EmbreeScene::nearest(const TraceRay& ray, TraceHit& hit) const {
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context = plain_context();
    rtcIntersect1(scene_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit.distance_m = query.ray.tfar;
    const unsigned instance = query.hit.instID[0];
    hit.normal = normal_at(instance != RTC_INVALID_GEOMETRY_ID ? instance : query.hit.geomID,
                           {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
    return true;
}

void EmbreeScene::mark_blocked(RayPacket& packet, std::size_t lanes) const {
    mark_blocked_in(scene_.get(), !has_instances_, packet, lanes);
}

std::uint32_t EmbreeScene::nearest(const RayPacket& packet, std::size_t lanes, HitPacket& hits) const {
    return nearest_in(scene_.get(), !has_instances_, packet, lanes, hits);
}

glm::dvec3 EmbreeScene::normal(const HitPacket& hits, std::size_t lane) const {
    return normal_at(hits.placement[lane], {hits.normal_x[lane], hits.normal_y[lane], hits.normal_z[lane]});
}

glm::dvec3 EmbreeScene::normal_at(unsigned placement, const glm::dvec3& ng) const {
    const glm::dvec3 n = cofactors(glm::dmat3(placements_[placement].trace_from_geometry)) * ng;
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0);
}

}  // namespace aoscore
