#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace aoscore {

/// Rays in one packet.
inline constexpr std::size_t kPacket = 16;

/// Rays of trace space whose directions are unit: distances are metres.
struct alignas(64) RayPacket {
    float origin_x[kPacket], origin_y[kPacket], origin_z[kPacket];
    float direction_x[kPacket], direction_y[kPacket], direction_z[kPacket];
    float reach_m[kPacket];
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
