#include "reference/tile_tracer.h"

#include "reference/falloff.h"

#include <algorithm>
#include <limits>

namespace aoscore {
namespace {

constexpr std::size_t kPacket = 16;
/// Rays held at once: their directions and order stay in the second-level cache.
constexpr std::size_t kBatchRays = 16384;

struct Packet {
    alignas(64) int valid[kPacket];
    RTCRayHit16 query;
};

void fill_ray(RTCRay16& ray, std::size_t lane, const glm::vec3& origin, const glm::vec3& direction,
              float tfar) {
    ray.org_x[lane] = origin.x;
    ray.org_y[lane] = origin.y;
    ray.org_z[lane] = origin.z;
    ray.tnear[lane] = 0;
    ray.dir_x[lane] = direction.x;
    ray.dir_y[lane] = direction.y;
    ray.dir_z[lane] = direction.z;
    ray.time[lane] = 0;
    ray.tfar[lane] = tfar;
    ray.mask[lane] = ~0u;
    ray.id[lane] = 0;
    ray.flags[lane] = 0;
}

}  // namespace

TileTracer::TileTracer(const EmbreeScene& scene, const std::vector<TruthQuery>& queries)
    : scene_(scene),
      queries_(queries),
      only_occlusion_(queries.size() == 1 && queries[0].falloff == Falloff::binary) {
    double reach = 0;
    for (const TruthQuery& q : queries) reach = std::max(reach, q.radius_m);
    // Rounded up: a hit between the radius and its float32 value is judged by the radius itself.
    reach_m_ = static_cast<float>(reach);
    if (!only_occlusion_) reach_m_ = std::nextafter(reach_m_, std::numeric_limits<float>::infinity());
}

void TileTracer::start(std::size_t sources) {
    sums_.assign(sources * queries_.size() * kReplicates, 0);
}

void TileTracer::trace(const std::vector<RaySource>& sources, int first, int last) {
    if (sources.empty()) return;
    const int step = static_cast<int>(std::max<std::size_t>(kReplicates, kBatchRays / sources.size()));
    for (int from = first; from < last; from += step) {
        const int to = std::min(last, from + step);
        batch_.clear();
        for (std::size_t s = 0; s < sources.size(); ++s) {
            batch_.add(sources[s], static_cast<std::uint32_t>(s), from, to);
        }
        batch_.sort();
        rays_ += batch_.size();
        if (only_occlusion_) {
            trace_occlusion(sources);
        } else {
            trace_distance(sources);
        }
    }
}

void TileTracer::trace_occlusion(const std::vector<RaySource>& sources) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    Packet packet;
    double* targets[kPacket];
    for (std::size_t first = 0; first < batch_.size(); first += kPacket) {
        const std::size_t count = std::min(kPacket, batch_.size() - first);
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
            packet.valid[lane] = lane < count ? -1 : 0;
            const RayBatch::Ray ray = batch_.sorted(first + std::min(lane, count - 1));
            fill_ray(packet.query.ray, lane, sources[ray.owner].origin, ray.direction, reach_m_);
            targets[lane] = &sums_[ray.owner * kReplicates + ray.replicate];
        }
        rtcOccluded16(packet.valid, scene_.handle(), &context, &packet.query.ray);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (packet.query.ray.tfar[lane] < 0) *targets[lane] += 1;
        }
    }
}

void TileTracer::trace_distance(const std::vector<RaySource>& sources) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    Packet packet;
    double* targets[kPacket];
    for (std::size_t first = 0; first < batch_.size(); first += kPacket) {
        const std::size_t count = std::min(kPacket, batch_.size() - first);
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
            packet.valid[lane] = lane < count ? -1 : 0;
            const RayBatch::Ray ray = batch_.sorted(first + std::min(lane, count - 1));
            fill_ray(packet.query.ray, lane, sources[ray.owner].origin, ray.direction, reach_m_);
            packet.query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            packet.query.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
            targets[lane] = &sums_[ray.owner * queries_.size() * kReplicates + ray.replicate];
        }
        rtcIntersect16(packet.valid, scene_.handle(), &context, &packet.query);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (packet.query.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
            const double t = packet.query.ray.tfar[lane];
            for (std::size_t q = 0; q < queries_.size(); ++q) {
                targets[lane][q * kReplicates] += darkening(queries_[q], t);
            }
        }
    }
}

}  // namespace aoscore
