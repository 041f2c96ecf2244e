#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace aoscore {

/// Rays in one packet.
inline constexpr std::size_t kPacket = 16;

/// Rays of trace space whose directions are unit: distances are metres. In the very order that Embree takes,
/// so that no ray is copied: members that have a value from the start keep it.
struct alignas(64) RayPacket {
    float origin_x[kPacket], origin_y[kPacket], origin_z[kPacket];
    float from_m[kPacket] = {};  ///< where the rays begin
    float direction_x[kPacket], direction_y[kPacket], direction_z[kPacket];
    float time[kPacket] = {};
    float reach_m[kPacket];
    std::uint32_t mask[kPacket];  ///< of the geometries to be met, all from the start
    std::uint32_t id[kPacket];    ///< whatever the rays are known by
    std::uint32_t flags[kPacket] = {};

    RayPacket() { std::fill_n(mask, kPacket, ~0u); }
};

/// The hits of a packet's rays. Lanes that met nothing hold what they will.
struct alignas(64) HitPacket {
    float distance_m[kPacket];
    float normal_x[kPacket], normal_y[kPacket], normal_z[kPacket];  ///< as RayTracer::normal() takes them
    unsigned placement[kPacket];                                    ///< the same
};

/// One ray of trace space, its direction unit.
struct TraceRay {
    glm::vec3 origin, direction;
    float from_m = 0, reach_m = 0;
};

struct TraceHit {
    float distance_m = 0;
    glm::dvec3 normal{0};  ///< unit, trace space; 0 of a degenerate triangle
};

}  // namespace aoscore
