#pragma once

#include "reference/integrator/early_out_predictor.h"
#include "reference/tracer/ray_batch.h"
#include "reference/tracer/ray_observer.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace aoscore {

/// Samples [first, last) of a pixel.
struct SampleRange {
    int first, last;
};

/// How many neighbouring pixels of a tile, `samples` rays each, have their rays sorted together: the more,
/// the closer lie the directions in a packet, and the farther apart its starts. Rays that reach less far, of
/// the scene's diagonal, part sooner from those that start elsewhere.
std::size_t pixels_sorted_together(double reach_m, double diagonal_m, int samples);

/// Sums of occlusion over the rays of the pixels of one tile.
class TileTracer {
  public:
    /// `observer` may be null; else it is told of every ray. `large_triangles_first` as TruthSettings has it.
    TileTracer(const RayTracer& scene, const std::vector<TruthQuery>& queries, const PointSets& points,
               bool large_triangles_first, RayObserver* observer = nullptr,
               RayDensity density = RayDensity::cosine);

    /// Begins with these pixels and sums of zero.
    void start(std::vector<RaySource> sources);
    /// Goes on from sums of an earlier trace, as sums() gave them; after start().
    void restore(std::size_t source, std::size_t query, std::span<const double> sums) {
        std::ranges::copy(sums, &sums_[(query * sources_.size() + source) * sums.size()]);
    }
    /// Traces these samples, one range a source, each where the last one ended, and adds to the sums.
    void trace(std::span<const SampleRange> ranges);

    /// Occlusion summed by blocks of block_size() of the samples traced so far: kBlocks values.
    std::span<const double> sums(std::size_t source, std::size_t query) const {
        return {&sums_[(query * sources_.size() + source) * kBlocks], kBlocks};
    }
    std::uint64_t rays() const { return rays_; }

  private:
    /// Sums by blocks of `before` samples become sums by blocks of `after` samples, a multiple.
    void merge_blocks(std::size_t source, int before, int after);
    /// Traces the samples of sources [begin, end), of which `active` have any.
    void trace_sources(std::span<const SampleRange> ranges, std::size_t begin, std::size_t end,
                       std::size_t active);
    void trace_occlusion();
    void trace_after_large_triangles();
    enum class Lanes { open, blocked };
    /// Traces packets of `count` rays, kPacket more of which may be read, and reports those that are open, or
    /// those that are blocked, in their order.
    template <class Report>
    void ask(const Occluders& occluders, const DirectedRay* rays, std::size_t count, Lanes reported,
             const Report& report) const;
    void trace_distance();
    void tell_observer(const RayPacket& packet, const HitPacket& hits, std::size_t lane, bool hit,
                       std::size_t owner);

    const RayTracer& scene_;
    const std::vector<TruthQuery>& queries_;
    RayObserver* observer_;
    bool only_occlusion_;
    float reach_m_;  // no query looks farther
    std::vector<RaySource> sources_;
    std::vector<float> origin_x_, origin_y_, origin_z_;  // by owner, as packets name them
    RayBatch batch_;
    std::vector<std::uint32_t> blocked_;          // by owner
    const Occluders* large_triangles_ = nullptr;  // asked first, where it may pay
    EarlyOutPredictor predictor_;
    std::vector<DirectedRay> passed_;  // the largest triangles
    std::vector<double> sums_;         // by query, then owner
    std::uint64_t rays_ = 0;
};

}  // namespace aoscore
