#include "reference/tracer/embree/embree_packets.h"

#include "reference/integrator/vectorise.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace aoscore {
namespace {

static_assert(sizeof(RayPacket) == sizeof(RTCRay16) && alignof(RayPacket) == alignof(RTCRay16));
static_assert(offsetof(RayPacket, origin_z) == offsetof(RTCRay16, org_z));
static_assert(offsetof(RayPacket, from_m) == offsetof(RTCRay16, tnear));
static_assert(offsetof(RayPacket, direction_z) == offsetof(RTCRay16, dir_z));
static_assert(offsetof(RayPacket, time) == offsetof(RTCRay16, time));
static_assert(offsetof(RayPacket, reach_m) == offsetof(RTCRay16, tfar));
static_assert(offsetof(RayPacket, mask) == offsetof(RTCRay16, mask));
static_assert(offsetof(RayPacket, flags) == offsetof(RTCRay16, flags));

/// Which lanes count: a window on this, -1 for each that does.
constexpr std::array<int, 2 * kPacket> kLanes = [] {
    std::array<int, 2 * kPacket> lanes{};
    std::fill_n(lanes.begin(), kPacket, -1);
    return lanes;
}();

/// The Embree form of the first `lanes` lanes, aligned as Embree wants it.
struct ValidLanes {
    alignas(64) int valid[kPacket];
    explicit ValidLanes(std::size_t lanes) {
        std::copy_n(kLanes.begin() + (kPacket - lanes), kPacket, valid);
    }
};

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

void mark_blocked_in(RTCScene scene, bool coherent, RayPacket& packet, std::size_t lanes) {
    const ValidLanes count(lanes);
    RTCIntersectContext context = context_of_packets(coherent);
    rtcOccluded16(count.valid, scene, &context, reinterpret_cast<RTCRay16*>(&packet));
}

std::uint32_t nearest_in(RTCScene scene, bool coherent, const RayPacket& packet, std::size_t lanes,
                         HitPacket& hits) {
    RTCIntersectContext context = context_of_packets(coherent);
    RTCRayHit16 query;
    std::memcpy(&query.ray, &packet, sizeof query.ray);
    const ValidLanes count(lanes);
    std::fill_n(query.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(query.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(count.valid, scene, &context, &query);
    return take_hits(query, hits) & lanes_below(lanes);
}

}  // namespace aoscore
