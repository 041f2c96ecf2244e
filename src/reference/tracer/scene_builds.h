#pragma once

#include "reference/tracer/ray_tracer.h"
#include "reference/tracer/reach.h"
#include "reference/truth.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace aoscore {

/// The trees that the rays of one picture are traced in.
struct ReachableScene {
    const RayTracer& tracer;         ///< has all that is within reach, and maybe more
    std::vector<char> within_reach;  ///< one flag an instance of the whole scene, see Reach
    /// Over instances, not in a scene that was built just now; 0 where it was there or is whole.
    std::uint64_t left_out_triangles = 0;
};

/// One scene, built for tracing as far as pictures of it need: whole, or without instances that are out of
/// reach. Rays that stay within reach give the same bits in every build. For any number of threads.
class SceneBuilds {
  public:
    /// `scene` must live until it is built whole, or else as long as this is used.
    SceneBuilds(const Scene& scene, const TraceBuild& build) : scene_(&scene), build_(build) {}

    /// Builds all of it, whether needed or not.
    void build_whole();
    /// For a picture whose rays reach `reach_m` (infinity allowed) from what the camera sees: what was built
    /// earlier where that has all it takes. The scene stays there as long as this lives.
    /// `rays` says how many there will be, as far as that is known, see tree_effort().
    ReachableScene reachable(const CameraFrame& frame, double reach_m,
                             double rays = std::numeric_limits<double>::infinity());

    const TraceBuild& build() const { return build_; }
    /// The most memory that the tracer has held for each of them, bytes, added up.
    std::size_t peak_bytes() const;

  private:
    struct Built {
        std::vector<char> instances;  ///< one flag an instance: it is there
        std::unique_ptr<RayTracer> tracer;
    };
    const Reach& reach();
    const RayTracer& add(std::vector<char> instances, double rays);
    std::uint64_t triangles_of(const std::vector<char>& instances) const;

    const Scene* scene_;
    TraceBuild build_;
    mutable std::mutex mutex_;  // of all that follows
    std::optional<Reach> reach_;
    std::vector<Built> built_;
    std::uint64_t triangles_in_parts_ = 0;
};

}  // namespace aoscore
