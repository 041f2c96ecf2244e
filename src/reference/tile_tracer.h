#pragma once

#include "reference/embree_scene.h"
#include "reference/ray_batch.h"
#include "reference/truth.h"

#include <vector>

namespace aoscore {

/// Sums of darkening over the rays of the pixels of one tile. One a thread; keeps its buffers between tiles.
class TileTracer {
  public:
    TileTracer(const EmbreeScene& scene, const std::vector<TruthQuery>& queries);

    /// Traces samples [first, last) of every source and adds to the sums, which begin at zero after start().
    void start(std::size_t sources);
    void trace(const std::vector<RaySource>& sources, int first, int last);

    /// Darkening summed by point set: kReplicates values.
    const double* sums(std::size_t source, std::size_t query) const {
        return &sums_[(source * queries_.size() + query) * kReplicates];
    }
    std::uint64_t rays() const { return rays_; }

  private:
    void trace_batch(const std::vector<RaySource>& sources);
    void trace_occlusion(const std::vector<RaySource>& sources);
    void trace_distance(const std::vector<RaySource>& sources);

    const EmbreeScene& scene_;
    const std::vector<TruthQuery>& queries_;
    bool only_occlusion_;
    float reach_m_;  // no query looks farther
    RayBatch batch_;
    std::vector<double> sums_;
    std::uint64_t rays_ = 0;
};

}  // namespace aoscore
