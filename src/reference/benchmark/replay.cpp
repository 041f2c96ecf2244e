#include "reference/benchmark/replay.h"

#include "core/sampling.h"
#include "core/threads.h"
#include "reference/benchmark/processor_time.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/tile_integrator.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <span>

namespace aoscore {
namespace {

constexpr int kRuns = 5;
constexpr int kBlockSide = 4;

struct RecordedTile {
    std::vector<RaySource> sources;
    std::vector<RTCRay> singles;
    std::vector<RTCRay16> by_pixel, by_block, traced;
};

RTCRay single_ray(const glm::vec3& origin, const glm::vec3& direction, float tfar) {
    return {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, tfar, ~0u, 0, 0};
}

/// Appends to the last packet; the caller sees to it that packets are full.
class PacketWriter {
  public:
    explicit PacketWriter(std::vector<RTCRay16>& packets) : packets_(packets) {}
    void add(const RTCRay& ray) {
        if (lane_ == 0) packets_.emplace_back();
        RTCRay16& p = packets_.back();
        p.org_x[lane_] = ray.org_x;
        p.org_y[lane_] = ray.org_y;
        p.org_z[lane_] = ray.org_z;
        p.tnear[lane_] = ray.tnear;
        p.dir_x[lane_] = ray.dir_x;
        p.dir_y[lane_] = ray.dir_y;
        p.dir_z[lane_] = ray.dir_z;
        p.time[lane_] = ray.time;
        p.tfar[lane_] = ray.tfar;
        p.mask[lane_] = ray.mask;
        p.id[lane_] = ray.id;
        p.flags[lane_] = ray.flags;
        lane_ = (lane_ + 1) % kPacket;
    }

  private:
    std::vector<RTCRay16>& packets_;
    std::size_t lane_ = 0;
};

/// Answers as a scene does, and keeps the packets that it is asked about.
class PacketRecorder final : public RayTracer {
  public:
    PacketRecorder(const RayTracer& scene, std::vector<RTCRay16>& packets)
        : scene_(scene), packets_(packets) {}

    void mark_blocked(RayPacket& packet, std::size_t lanes) const override {
        keep(packet);
        scene_.mark_blocked(packet, lanes);
    }
    std::uint32_t nearest(const RayPacket& packet, std::size_t lanes, HitPacket& hits) const override {
        keep(packet);
        return scene_.nearest(packet, lanes, hits);
    }

    const glm::dvec3& centre() const override { return scene_.centre(); }
    double diagonal_m() const override { return scene_.diagonal_m(); }
    std::size_t triangle_count() const override { return scene_.triangle_count(); }
    std::size_t peak_bytes() const override { return scene_.peak_bytes(); }
    bool first_hit(const CameraFrame::Ray& ray, double near, double far, SurfaceHit& hit) const override {
        return scene_.first_hit(ray, near, far, hit);
    }
    bool occluded(const TraceRay& ray) const override { return scene_.occluded(ray); }
    bool nearest(const TraceRay& ray, TraceHit& hit) const override { return scene_.nearest(ray, hit); }
    glm::dvec3 normal(const HitPacket& hits, std::size_t lane) const override {
        return scene_.normal(hits, lane);
    }
    const Occluders* large_triangles() const override { return nullptr; }
    bool triangles_near(const glm::dvec3& centre, double radius_m, std::size_t limit,
                        const std::vector<char>& counted,
                        std::vector<TraceTriangle>& triangles) const override {
        return scene_.triangles_near(centre, radius_m, limit, counted, triangles);
    }

  private:
    void keep(const RayPacket& packet) const {
        static_assert(sizeof(RayPacket) == sizeof(RTCRay16));
        std::memcpy(&packets_.emplace_back(), &packet, sizeof packet);
    }

    const RayTracer& scene_;
    std::vector<RTCRay16>& packets_;
};

/// A tile all of whose pixels see a surface, its rays in all orders; empty for any other tile.
RecordedTile record(const EmbreeScene& scene, const CameraFrame& frame, const Tile& tile,
                    const PointSets& points, const std::vector<TruthQuery>& queries, int samples,
                    float tfar) {
    RecordedTile recorded;
    PrimaryHits hits{Mask(frame.width(), frame.height()), ImageF(frame.width(), frame.height()),
                     Image<glm::vec3>(frame.width(), frame.height())};
    SurfaceHit hit;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (!find_surface(scene, frame, x, y, hits, hit)) return {};
            recorded.sources.push_back(ray_source(hit, {}, hits.depth.index(x, y)));
        }
    }
    if (recorded.sources.size() != std::size_t{kTileSide} * kTileSide) return {};
    const auto rays_of_pixel = static_cast<std::size_t>(samples);
    const int block = block_size(samples);
    RayBatch all(points);
    for (std::size_t s = 0; s < recorded.sources.size(); ++s)
        all.add(recorded.sources[s], s, 0, samples, block);
    const auto with_origin = [&](const DirectedRay& ray, std::size_t source) {
        return single_ray(recorded.sources[source].origin, {ray.x, ray.y, ray.z}, tfar);
    };
    const auto ray = [&](std::size_t source, std::size_t k) {
        return with_origin(all.rays()[source * rays_of_pixel + k], source);
    };

    PacketRecorder recorder(scene, recorded.traced);
    TileTracer tracer(recorder, queries, points, false);
    tracer.start(recorded.sources);
    tracer.trace(std::vector<SampleRange>(recorded.sources.size(), {0, samples}));

    PacketWriter by_pixel(recorded.by_pixel), by_block(recorded.by_block);
    for (std::size_t s = 0; s < recorded.sources.size(); ++s) {
        RayBatch one(points);
        one.add(recorded.sources[s], 0, 0, samples, block);
        one.sort();
        for (std::size_t place = 0; place < one.size(); ++place)
            by_pixel.add(with_origin(one.sorted()[place], s));
        for (std::size_t k = 0; k < rays_of_pixel; ++k) recorded.singles.push_back(ray(s, k));
    }
    for (int block_y = 0; block_y < kTileSide; block_y += kBlockSide) {
        for (int block_x = 0; block_x < kTileSide; block_x += kBlockSide) {
            for (std::size_t k = 0; k < rays_of_pixel; ++k) {
                for (int lane = 0; lane < kBlockSide * kBlockSide; ++lane) {
                    const int x = block_x + lane % kBlockSide, y = block_y + lane / kBlockSide;
                    by_block.add(ray(static_cast<std::size_t>(y * kTileSide + x), k));
                }
            }
        }
    }
    return recorded;
}

void replay(const EmbreeScene& scene, const std::vector<RTCRay16>& packets, RayQuestion question) {
    RTCIntersectContext context = scene.packet_context();
    alignas(64) int valid[kPacket];
    std::fill_n(valid, kPacket, -1);
    RTCRayHit16 query;
    for (const RTCRay16& packet : packets) {
        query.ray = packet;
        if (question == RayQuestion::occlusion) {
            rtcOccluded16(valid, scene.handle(), &context, &query.ray);
            continue;
        }
        std::fill_n(query.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
        std::fill_n(query.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
        rtcIntersect16(valid, scene.handle(), &context, &query);
    }
}

void replay(const EmbreeScene& scene, const std::vector<RTCRay>& rays, RayQuestion question) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    for (const RTCRay& recorded : rays) {
        query.ray = recorded;
        if (question == RayQuestion::occlusion) {
            rtcOccluded1(scene.handle(), &context, &query.ray);
            continue;
        }
        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene.handle(), &context, &query);
    }
}

std::vector<TruthQuery> queries_for(RayQuestion question, double radius_m) {
    if (question == RayQuestion::occlusion) return {{Falloff::binary, radius_m, 0}};
    return {
        {Falloff::binary, radius_m, 0}, {Falloff::quadratic, radius_m, 0}, {Falloff::xegtao, radius_m, 0}};
}

}  // namespace

double ReplayRates::best_plain() const {
    return std::max({single, pixel, block});
}

ReplayRates replay_rates(const EmbreeScene& scene, const CameraFrame& frame, double radius_m,
                         RayQuestion question, int samples, int tiles) {
    const PointSets points(PointKind::scrambled_sobol, samples);
    const std::vector<TruthQuery> queries = queries_for(question, radius_m);
    const std::vector<Tile> all =
        random_tiles(frame.width(), frame.height(), static_cast<std::size_t>(tiles));
    std::vector<RecordedTile> recorded(all.size());
    parallel_for(all.size(), [&](std::size_t i) {
        recorded[i] = record(scene, frame, all[i], points, queries, samples, static_cast<float>(radius_m));
    });
    ReplayRates rates;
    for (const RecordedTile& tile : recorded) rates.rays += tile.singles.size();

    const std::size_t group = tiles_at_a_time(recorded.size());
    const auto time = [&](double& best, const std::function<void(std::span<const RecordedTile>)>& work) {
        const double seconds = seconds_of([&] {
            parallel_for((recorded.size() + group - 1) / group, [&](std::size_t g) {
                const FlushDenormals flush;
                const std::size_t first = g * group;
                work(std::span(recorded).subspan(first, std::min(group, recorded.size() - first)));
            });
        });
        best = std::max(best, static_cast<double>(rates.rays) / seconds / 1e6);
    };
    for (int run = 0; run < kRuns; ++run) {
        time(rates.traced, [&](std::span<const RecordedTile> part) {
            TileTracer tracer(scene, queries, points, true);
            for (const RecordedTile& tile : part) {
                tracer.start(tile.sources);
                tracer.trace(std::vector<SampleRange>(tile.sources.size(), {0, samples}));
            }
        });
        const auto replayed = [&](auto rays) {
            return [&scene, question, rays](std::span<const RecordedTile> part) {
                for (const RecordedTile& tile : part) replay(scene, tile.*rays, question);
            };
        };
        time(rates.packets, replayed(&RecordedTile::traced));
        time(rates.pixel, replayed(&RecordedTile::by_pixel));
        time(rates.block, replayed(&RecordedTile::by_block));
        time(rates.single, replayed(&RecordedTile::singles));
    }
    return rates;
}

}  // namespace aoscore
