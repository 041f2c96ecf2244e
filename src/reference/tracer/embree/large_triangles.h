#pragma once

#include "reference/tracer/embree/embree_handles.h"
#include "reference/tracer/embree/embree_packets.h"
#include "reference/tracer/ray_tracer.h"

#include <cstddef>
#include <span>

namespace aoscore {

/// The few largest triangles of a scene in a tree of their own. What blocks a ray there blocks it in the
/// whole scene, whose tree then need not be walked: of far-reaching rays in rooms and courts most end at
/// walls, floors and vaults, and a tree of a few hundred triangles stays in the nearest cache.
class LargeTriangles final : public Occluders {
  public:
    /// So many of them.
    static constexpr std::size_t kTriangles = 256;
    /// Scenes with fewer triangles than this are as fast themselves.
    static constexpr std::size_t kLeastSceneTriangles = 32 * kTriangles;

    /// Of triangles whose corners are float32 values, the very ones that the whole scene has: the same ray
    /// then meets the same triangle in both. Throws internal_error.
    /// `coherent`: as packets are traced in the whole scene.
    LargeTriangles(RTCDevice device, std::span<const TraceTriangle> triangles, bool coherent);

    void mark_blocked(RayPacket& packet, std::size_t lanes) const override {
        mark_blocked_in(scene_.get(), coherent_, packet, lanes);
    }

  private:
    SceneHandle scene_;
    bool coherent_;
};

}  // namespace aoscore
