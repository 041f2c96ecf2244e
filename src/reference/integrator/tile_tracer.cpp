#include "reference/integrator/tile_tracer.h"

#include "reference/estimate/falloff.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/vectorise.h"
#include "reference/tracer/transpose.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace aoscore {
namespace {

/// Rays held at once: their directions and order stay in the second-level cache.
constexpr std::size_t kBatchRays = 16384;

/// LargeTriangles are not tried by rays that reach less far, in diagonals of the scene.
constexpr double kLeastReachForLargeTriangles = 0.1;

/// Rays that are sorted together at least, where they reach less far than this part of the diagonal and where
/// they reach farther, and the pixels that they belong to: what was the fastest at 640x360 and 1920x1080.
constexpr double kShortReach = 0.1;
constexpr int kShortRaysTogether = 2048, kLongRaysTogether = 16384;
/// With fewer cells than that, packets of one cell look too far apart.
constexpr int kFewestCells = 128;
/// More cells would not stay in the second-level cache.
constexpr int kMostCells = 4096;

constexpr int kFewestPixelsTogether = 16, kMostPixelsTogether = kTileSide * kTileSide;

/// Writes the origins, directions and owners (as ids) of rays to a packet.
AOSCORE_VECTORISE
void fill_sorted(RayPacket& packet, const DirectedRay* __restrict rays, const RayOrigins& origins) {
    const float* __restrict from_x = origins.x, * __restrict from_y = origins.y, * __restrict from_z = origins.z;
    for (std::size_t lane = 0; lane < kPacket; lane += 4) {
        FourWords x = four_words(rays + lane), y = four_words(rays + lane + 1),
                  z = four_words(rays + lane + 2), whose = four_words(rays + lane + 3);
        transpose(x, y, z, whose);
        std::memcpy(packet.direction_x + lane, &x, sizeof x);
        std::memcpy(packet.direction_y + lane, &y, sizeof y);
        std::memcpy(packet.direction_z + lane, &z, sizeof z);
        std::memcpy(packet.id + lane, &whose, sizeof whose);
    }
    const std::uint32_t* owner = packet.id;
    for (std::size_t lane = 0; lane < kPacket; ++lane) packet.origin_x[lane] = from_x[owner[lane]];
    for (std::size_t lane = 0; lane < kPacket; ++lane) packet.origin_y[lane] = from_y[owner[lane]];
    for (std::size_t lane = 0; lane < kPacket; ++lane) packet.origin_z[lane] = from_z[owner[lane]];
}

/// Rays one after the other, kPacket more of which may be read.
struct ListedRays {
    const DirectedRay* rays;
    std::size_t count;
    RayOrigins origins;

    std::size_t size() const { return count; }
    void fill(RayPacket& packet, std::size_t first) const { fill_sorted(packet, rays + first, origins); }
};

void set_reach(RayPacket& packet, float reach_m) {
    std::fill_n(packet.reach_m, kPacket, reach_m);
}

/// A bit for every lane whose ray was found blocked.
inline std::uint32_t blocked_lanes(const RayPacket& packet) {
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < kPacket; ++lane)
        bits |= (std::bit_cast<std::uint32_t>(packet.reach_m[lane]) >> 31) << lane;
    return bits;
}

/// A bit for every lane below `count`.
inline std::uint32_t lanes_below(std::size_t count) {
    return (1u << count) - 1;
}

}  // namespace

std::size_t pixels_sorted_together(double reach_m, double diagonal_m, int samples) {
    const int rays = reach_m < kShortReach * diagonal_m ? kShortRaysTogether : kLongRaysTogether;
    return static_cast<std::size_t>(
        std::clamp(rays / std::max(samples, 1), kFewestPixelsTogether, kMostPixelsTogether));
}

TileTracer::TileTracer(const RayTracer& scene, const std::vector<TruthQuery>& queries,
                       const PointSets& points, bool large_triangles_first, RayObserver* observer,
                       RayDensity density)
    : scene_(scene),
      queries_(queries),
      observer_(observer),
      only_occlusion_(observer == nullptr && queries.size() == 1 && queries[0].falloff == Falloff::binary),
      points_(points),
      density_(density),
      batch_(points, density) {
    double reach = 0;
    for (const TruthQuery& q : queries) reach = std::max(reach, q.radius_m);
    reach_m_ = static_cast<float>(reach);
    // A hit between a radius and its float32 value is judged by the radius itself.
    if (!only_occlusion_) reach_m_ = std::nextafter(reach_m_, std::numeric_limits<float>::infinity());
    if (large_triangles_first && only_occlusion_ && reach > kLeastReachForLargeTriangles * scene.diagonal_m())
        large_triangles_ = scene.large_triangles();
}

void TileTracer::start(std::vector<RaySource> sources) {
    sources_ = std::move(sources);
    const std::size_t owners = sources_.size() * kBlocks;
    sums_.assign(owners * queries_.size(), 0);
    blocked_.resize(owners);
    if (observer_ != nullptr) observer_->start(sources_.size());
    origin_x_.clear();
    origin_y_.clear();
    origin_z_.clear();
    for (const RaySource& source : sources_) {
        origin_x_.insert(origin_x_.end(), kBlocks, source.origin.x);
        origin_y_.insert(origin_y_.end(), kBlocks, source.origin.y);
        origin_z_.insert(origin_z_.end(), kBlocks, source.origin.z);
    }
}

void TileTracer::trace(std::span<const SampleRange> ranges) {
    int longest = 0;
    for (const SampleRange& range : ranges) longest = std::max(longest, range.last - range.first);
    if (longest == 0) return;
    for (std::size_t s = 0; s < ranges.size(); ++s) {
        if (ranges[s].first > 0) merge_blocks(s, block_size(ranges[s].first), block_size(ranges[s].last));
    }
    std::vector<SampleRange> left(ranges.begin(), ranges.end());
    const std::size_t together = pixels_sorted_together(reach_m_, scene_.diagonal_m(), longest);
    trace_by_cells(left);
    for (std::size_t begin = 0, end = 0; end < left.size(); begin = end) {
        std::size_t active = 0;
        for (; end < left.size() && active < together; ++end)
            active += left[end].last > left[end].first ? 1 : 0;
        if (active > 0) trace_sources(left, begin, end, active);
    }
}

void TileTracer::trace_by_cells(std::span<SampleRange> ranges) {
    if (points_.kind() != PointKind::scrambled_sobol) return;
    // Distances of far rays take so long that packets which look a little apart cost more than sorting.
    if (!only_occlusion_ && reach_m_ >= kShortReach * scene_.diagonal_m()) return;
    std::vector<std::size_t> active;
    for (std::size_t s = 0; s < ranges.size(); ++s) {
        if (ranges[s].last > ranges[s].first) active.push_back(s);
    }
    const SampleRange range = ranges[active.front()];
    std::erase_if(active, [&](std::size_t s) { return ranges[s] != range; });
    const std::vector<std::vector<std::size_t>> groups = groups_alike(std::move(active));
    for (int first = range.first; !groups.empty() && first < range.last;) {
        const int size = std::min(net_after(first, range.last), kMostCells);
        if (size < kFewestCells) break;
        if (!cells_ || cells_->first() != first || cells_->size() != size)
            cells_.emplace(points_, first, size);
        for (const std::vector<std::size_t>& group : groups) {
            cell_packets_.start(*cells_, density_, block_size(range.last));
            expected_.assign(blocked_.size(), 0);
            for (const std::size_t s : group) {
                cell_packets_.add(sources_[s], static_cast<std::uint32_t>(s * kBlocks));
                expect(s, {first, first + size}, block_size(range.last));
                ranges[s].first = first + size;
            }
            cell_packets_.close();
            trace_rays(cell_packets_);
        }
        first += size;
    }
}

std::vector<std::vector<std::size_t>> TileTracer::groups_alike(std::vector<std::size_t> waiting) const {
    std::vector<std::vector<std::size_t>> groups;
    while (waiting.size() >= CellPackets::kLeast) {
        const std::size_t leader = waiting.front();
        const auto unlike = std::ranges::stable_partition(
            waiting, [&](std::size_t s) { return lie_alike(sources_[leader].frame, sources_[s].frame); });
        const std::vector<std::size_t> alike(waiting.begin(), unlike.begin());
        waiting.erase(waiting.begin(), unlike.begin());
        if (alike.size() < CellPackets::kLeast) continue;
        const std::size_t parts = alike.size() / CellPackets::kLeast;
        for (std::size_t part = 0; part < parts; ++part) {
            const auto at = [&](std::size_t i) {
                return alike.begin() + static_cast<std::ptrdiff_t>(i * alike.size() / parts);
            };
            groups.emplace_back(at(part), at(part + 1));
        }
    }
    return groups;
}

void TileTracer::expect(std::size_t source, const SampleRange& range, int block) {
    for (int from = range.first; from < range.last;) {
        const int to = std::min(range.last, (from / block + 1) * block);
        expected_[source * kBlocks + static_cast<std::size_t>(from / block)] +=
            static_cast<std::uint32_t>(to - from);
        from = to;
    }
}

void TileTracer::trace_sources(std::span<const SampleRange> ranges, std::size_t begin, std::size_t end,
                               std::size_t active) {
    int longest = 0;
    for (std::size_t s = begin; s < end; ++s) longest = std::max(longest, ranges[s].last - ranges[s].first);
    const int step = static_cast<int>(std::max<std::size_t>(1, kBatchRays / active));
    for (int done = 0; done < longest; done += step) {
        batch_.clear();
        expected_.assign(blocked_.size(), 0);
        for (std::size_t s = begin; s < end; ++s) {
            const int from = ranges[s].first + done;
            const int to = std::min(ranges[s].last, from + step);
            if (from >= to) continue;
            const int block = block_size(ranges[s].last);
            batch_.add(sources_[s], s, from, to, block);
            expect(s, {from, to}, block);
        }
        batch_.sort();
        trace_rays(ListedRays{batch_.sorted(), batch_.size(), origins()});
    }
}

RayOrigins TileTracer::origins() const {
    return {origin_x_.data(), origin_y_.data(), origin_z_.data()};
}

template <class Rays>
void TileTracer::trace_rays(const Rays& rays) {
    rays_ += rays.size();
    if (only_occlusion_) {
        trace_occlusion(rays);
    } else {
        trace_distance(rays);
    }
}

void TileTracer::merge_blocks(std::size_t source, int before, int after) {
    const auto merged = static_cast<std::size_t>(after / before);
    if (merged <= 1) return;
    for (std::size_t q = 0; q < queries_.size(); ++q) {
        double* sums = &sums_[(q * sources_.size() + source) * kBlocks];
        for (std::size_t block = 0; block < kBlocks; ++block) {
            double sum = 0;
            for (std::size_t part = block * merged;
                 part < std::min<std::size_t>((block + 1) * merged, kBlocks); ++part)
                sum += sums[part];
            sums[block] = sum;
        }
    }
}

template <class Rays>
void TileTracer::trace_occlusion(const Rays& rays) {
    std::fill(blocked_.begin(), blocked_.end(), 0u);
    if (large_triangles_ != nullptr && predictor_.worth_it()) {
        trace_after_large_triangles(rays);
    } else {
        ask(scene_, rays, Lanes::blocked,
            [&](const RayPacket& packet, std::size_t lane) { ++blocked_[packet.id[lane]]; });
    }
    for (std::size_t i = 0; i < blocked_.size(); ++i) sums_[i] += blocked_[i];
}

template <class Rays>
void TileTracer::trace_after_large_triangles(const Rays& rays) {
    passed_.clear();
    ask(*large_triangles_, rays, Lanes::open, [&](const RayPacket& packet, std::size_t lane) {
        passed_.push_back(
            {packet.direction_x[lane], packet.direction_y[lane], packet.direction_z[lane], packet.id[lane]});
    });
    const std::size_t passed = passed_.size();
    predictor_.learn(rays.size(), rays.size() - passed);
    blocked_ = expected_;
    passed_.resize(passed + kPacket, passed > 0 ? passed_.back() : DirectedRay{});
    ask(scene_, ListedRays{passed_.data(), passed, origins()}, Lanes::open,
        [&](const RayPacket& packet, std::size_t lane) { --blocked_[packet.id[lane]]; });
}

template <class Rays, class Report>
void TileTracer::ask(const Occluders& occluders, const Rays& rays, Lanes reported,
                     const Report& report) const {
    // Two in turns: to read at once what has just been written would wait for it.
    RayPacket packets[2];
    const std::size_t count = rays.size();
    const std::uint32_t flip = reported == Lanes::open ? ~0u : 0u;
    const auto report_packet = [&](std::size_t first) {
        const RayPacket& packet = packets[first / kPacket % 2];
        std::uint32_t left = (blocked_lanes(packet) ^ flip) & lanes_below(std::min(kPacket, count - first));
        for (; left != 0; left &= left - 1) report(packet, static_cast<std::size_t>(std::countr_zero(left)));
    };
    for (std::size_t first = 0; first < count; first += kPacket) {
        RayPacket& packet = packets[first / kPacket % 2];
        rays.fill(packet, first);
        set_reach(packet, reach_m_);
        occluders.mark_blocked(packet, std::min(kPacket, count - first));
        if (first > 0) report_packet(first - kPacket);
    }
    if (count > 0) report_packet((count - 1) / kPacket * kPacket);
}

template <class Rays>
void TileTracer::trace_distance(const Rays& rays) {
    RayPacket packet;
    HitPacket hits;
    for (std::size_t first = 0; first < rays.size(); first += kPacket) {
        const std::size_t count = std::min(kPacket, rays.size() - first);
        rays.fill(packet, first);
        set_reach(packet, reach_m_);
        const std::uint32_t hit = scene_.nearest(packet, count, hits);
        for (std::size_t lane = 0; observer_ != nullptr && lane < count; ++lane)
            tell_observer(packet, hits, lane, (hit >> lane & 1u) != 0, packet.id[lane]);
        for (std::uint32_t left = hit; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const double t = hits.distance_m[lane];
            for (std::size_t q = 0; q < queries_.size(); ++q) {
                sums_[q * blocked_.size() + packet.id[lane]] += occlusion_at(queries_[q], t);
            }
        }
    }
}

void TileTracer::tell_observer(const RayPacket& packet, const HitPacket& hits, std::size_t lane, bool hit,
                               std::size_t owner) {
    const std::size_t source = owner / kBlocks;
    ObservedRay ray;
    ray.block = owner % kBlocks;
    ray.origin = sources_[source].origin;
    ray.direction = {packet.direction_x[lane], packet.direction_y[lane], packet.direction_z[lane]};
    ray.hit = hit;
    if (ray.hit) {
        ray.distance_m = hits.distance_m[lane];
        ray.normal = scene_.normal(hits, lane);
    }
    observer_->observe(source, ray);
}

}  // namespace aoscore
