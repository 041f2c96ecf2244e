#pragma once

#include "reference/tracer/ray_packet.h"

#include <embree3/rtcore.h>

#include <cstddef>
#include <cstdint>

namespace aoscore {

/// `coherent`: the rays of a packet are of similar direction.
RTCIntersectContext context_of_packets(bool coherent);

/// Makes the reach of those of the first `lanes` rays negative that something of this scene blocks.
void mark_blocked_in(RTCScene scene, bool coherent, RayPacket& packet, std::size_t lanes);

/// The first hits of the first `lanes` rays in this scene, one bit for each that meets something.
std::uint32_t nearest_in(RTCScene scene, bool coherent, const RayPacket& packet, std::size_t lanes,
                         HitPacket& hits);

}  // namespace aoscore
