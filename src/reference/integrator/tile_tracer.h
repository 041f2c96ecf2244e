#pragma once

#include "reference/integrator/early_out_predictor.h"
#include "reference/sampling/point_cells.h"
#include "reference/tracer/cell_packets.h"
#include "reference/tracer/ray_batch.h"
#include "reference/tracer/ray_observer.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace aoscore {

/// Samples [first, last) of a pixel.
struct SampleRange {
    int first, last;
    bool operator==(const SampleRange&) const = default;
};

/// How many neighbouring pixels of a tile, `samples` rays each, have their rays sorted together: the more,
/// the closer lie the directions in a packet, and the farther apart its starts. Rays that reach less far, of
/// the scene's diagonal, part sooner from those that start elsewhere.
std::size_t pixels_sorted_together(double reach_m, double diagonal_m, int samples);

/// Where rays start, by owner.
struct RayOrigins {
    const float* x;
    const float* y;
    const float* z;
};

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
    RayOrigins origins() const;
    /// Traces as much as can be of what there is to trace, by CellPackets, and takes it off the ranges.
    void trace_by_cells(std::span<SampleRange> ranges);
    /// Sources whose hemispheres lie alike in groups of at least
    /// CellPackets::kLeast, and hardly more; without those that are too few.
    std::vector<std::vector<std::size_t>> groups_alike(std::vector<std::size_t> waiting) const;
    /// Counts rays that are about to be traced.
    void expect(std::size_t source, const SampleRange& range, int block);
    template <class Rays>
    void trace_rays(const Rays& rays);
    template <class Rays>
    void trace_occlusion(const Rays& rays);
    template <class Rays>
    void trace_after_large_triangles(const Rays& rays);
    enum class Lanes { open, blocked };
    /// Traces rays in packets and reports those that are open, or those that are blocked, in their order.
    template <class Rays, class Report>
    void ask(const Occluders& occluders, const Rays& rays, Lanes reported, const Report& report) const;
    template <class Rays>
    void trace_distance(const Rays& rays);
    void tell_observer(const RayPacket& packet, const HitPacket& hits, std::size_t lane, bool hit,
                       std::size_t owner);

    const RayTracer& scene_;
    const std::vector<TruthQuery>& queries_;
    RayObserver* observer_;
    bool only_occlusion_;
    float reach_m_;  // no query looks farther
    std::vector<RaySource> sources_;
    std::vector<float> origin_x_, origin_y_, origin_z_;  // by owner, as packets name them
    const PointSets& points_;
    RayDensity density_;
    RayBatch batch_;
    std::optional<PointCells> cells_;  // the last ones
    CellPackets cell_packets_;
    std::vector<std::uint32_t> expected_;         // by owner, rays of what is being traced
    std::vector<std::uint32_t> blocked_;          // by owner
    const Occluders* large_triangles_ = nullptr;  // asked first, where it may pay
    EarlyOutPredictor predictor_;
    std::vector<DirectedRay> passed_;  // the largest triangles
    std::vector<double> sums_;         // by query, then owner
    std::uint64_t rays_ = 0;
};

}  // namespace aoscore
