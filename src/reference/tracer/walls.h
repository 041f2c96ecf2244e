#pragma once

#include "reference/tracer/embree_handles.h"
#include "reference/tracer/trace_triangle.h"

#include <cstddef>
#include <span>

namespace aoscore {

/// The few largest triangles of a scene in a tree of their own. What blocks a ray there blocks it in the
/// whole scene, whose tree then need not be walked: of far-reaching rays in rooms and courts most end at
/// walls, floors and vaults, and a tree of a few hundred triangles stays in the nearest cache.
class Walls {
  public:
    /// So many of them.
    static constexpr std::size_t kTriangles = 256;
    /// Scenes with fewer triangles than this are as fast themselves.
    static constexpr std::size_t kLeastSceneTriangles = 32 * kTriangles;

    /// Of triangles whose corners are float32 values, the very ones that the whole scene has: the same ray
    /// then meets the same triangle in both. Throws internal_error.
    Walls(RTCDevice device, std::span<const TraceTriangle> triangles);

    RTCScene handle() const { return scene_.get(); }

  private:
    SceneHandle scene_;
};

/// Whether it pays to ask walls first, learnt from the rays that were asked. Answers never change a result.
class WallHabit {
  public:
    bool worth_it() const {
        return kLeastPart * static_cast<double>(asked_) <= static_cast<double>(blocked_);
    }
    void learn(std::size_t asked, std::size_t blocked) {
        asked_ = asked_ / 2 + asked;  // what lies far back counts less
        blocked_ = blocked_ / 2 + blocked;
    }

  private:
    /// Walls take half the time of the whole scene, and rays that pass them lie apart from each other, so
    /// that they take three times as long as in full packets.
    static constexpr double kLeastPart = 0.8;
    std::size_t asked_ = 0, blocked_ = 0;
};

}  // namespace aoscore
