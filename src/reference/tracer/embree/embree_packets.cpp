#include "reference/tracer/embree/embree_packets.h"

#include "reference/integrator/vectorise.h"

#include <algorithm>
#include <bit>

namespace aoscore {
namespace {

/// Embree's form of a packet, and which of its lanes count.
AOSCORE_VECTORISE
void fill(RTCRay16& ray, int* __restrict valid, const RayPacket& packet, std::size_t lanes) {
    std::copy_n(packet.origin_x, kPacket, ray.org_x);
    std::copy_n(packet.origin_y, kPacket, ray.org_y);
    std::copy_n(packet.origin_z, kPacket, ray.org_z);
    std::copy_n(packet.direction_x, kPacket, ray.dir_x);
    std::copy_n(packet.direction_y, kPacket, ray.dir_y);
    std::copy_n(packet.direction_z, kPacket, ray.dir_z);
    std::copy_n(packet.reach_m, kPacket, ray.tfar);
    std::fill_n(ray.tnear, kPacket, 0.0f);
    std::fill_n(ray.time, kPacket, 0.0f);
    std::fill_n(ray.mask, kPacket, ~0u);
    std::fill_n(ray.id, kPacket, 0u);
    std::fill_n(ray.flags, kPacket, 0u);
    const int count = static_cast<int>(lanes);
    for (int lane = 0; lane < static_cast<int>(kPacket); ++lane) valid[lane] = lane < count ? -1 : 0;
}

AOSCORE_VECTORISE
std::uint32_t take_hits(const RTCRayHit16& query, HitPacket& hits) {
    std::copy_n(query.ray.tfar, kPacket, hits.distance_m);
    std::copy_n(query.hit.Ng_x, kPacket, hits.normal_x);
    std::copy_n(query.hit.Ng_y, kPacket, hits.normal_y);
    std::copy_n(query.hit.Ng_z, kPacket, hits.normal_z);
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
        const unsigned geometry = query.hit.geomID[lane], instance = query.hit.instID[0][lane];
        hits.placement[lane] = instance != RTC_INVALID_GEOMETRY_ID ? instance : geometry;
        bits |= std::uint32_t{geometry != RTC_INVALID_GEOMETRY_ID} << lane;
    }
    return bits;
}

/// A bit for every lane that Embree found blocked, for which it sets tfar to minus infinity.
std::uint32_t blocked_lanes(const RTCRay16& ray) {
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < kPacket; ++lane)
        bits |= (std::bit_cast<std::uint32_t>(ray.tfar[lane]) >> 31) << lane;
    return bits;
}

std::uint32_t lanes_below(std::size_t count) {
    return (1u << count) - 1;
}

}  // namespace

RTCIntersectContext context_of_packets(bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

std::uint32_t occluded_in(RTCScene scene, RTCIntersectContext context, const RayPacket& packet,
                          std::size_t lanes) {
    RTCRay16 ray;
    alignas(64) int valid[kPacket];
    fill(ray, valid, packet, lanes);
    rtcOccluded16(valid, scene, &context, &ray);
    return blocked_lanes(ray) & lanes_below(lanes);
}

std::uint32_t nearest_in(RTCScene scene, RTCIntersectContext context, const RayPacket& packet,
                         std::size_t lanes, HitPacket& hits) {
    RTCRayHit16 query;
    alignas(64) int valid[kPacket];
    fill(query.ray, valid, packet, lanes);
    std::fill_n(query.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(query.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(valid, scene, &context, &query);
    return take_hits(query, hits) & lanes_below(lanes);
}

}  // namespace aoscore
