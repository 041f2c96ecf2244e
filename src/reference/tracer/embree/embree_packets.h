#pragma once

#include "reference/tracer/ray_packet.h"

#include <embree3/rtcore.h>

#include <cstddef>
#include <cstdint>

namespace aoscore {

RTCIntersectContext context_of_packets(bool coherent);

/// One bit for each of the first `lanes` rays that something of this scene blocks.
std::uint32_t occluded_in(RTCScene scene, RTCIntersectContext context, const RayPacket& packet,
                          std::size_t lanes);

/// The first hits of the first `lanes` rays in this scene, one bit for each that meets something.
std::uint32_t nearest_in(RTCScene scene, RTCIntersectContext context, const RayPacket& packet,
                         std::size_t lanes, HitPacket& hits);

}  // namespace aoscore
