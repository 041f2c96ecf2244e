#include "reference/truth.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/sampling.h"
#include "core/threads.h"
#include "reference/embree_scene.h"
#include "reference/estimate.h"
#include "reference/flush_denormals.h"
#include "reference/tile_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

/// Pixels of a tile's side. Larger tiles make more coherent packets of more distant starts.
constexpr int kTile = 8;

struct Tile {
    int x0, y0, x1, y1;
};

std::vector<Tile> tiles_of(int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += kTile) {
        for (int x = 0; x < width; x += kTile) {
            tiles.push_back({x, y, std::min(x + kTile, width), std::min(y + kTile, height)});
        }
    }
    return tiles;
}

void check(const std::vector<TruthQuery>& queries, const TruthSettings& settings) {
    if (settings.samples < 1) {
        throw usage_error(fmt::format("{} samples a pixel", settings.samples), "samples", "at least 1");
    }
    if (queries.empty()) throw usage_error("no radius to trace", "radius", "at least one");
    for (const TruthQuery& query : queries) {
        if (!(query.radius_m > 0)) {
            throw usage_error(fmt::format("radius {} m", query.radius_m), "radius",
                              "more than 0, or infinity");
        }
        if (query.falloff == Falloff::alchemy && !(query.u_m > 0 && std::isfinite(query.u_m))) {
            throw usage_error(fmt::format("u is {} m", query.u_m), "u", "more than 0, finite");
        }
    }
}

PrimaryHits empty_hits(int width, int height) {
    return {Mask(width, height), ImageF(width, height), Image<glm::vec3>(width, height, glm::vec3(0))};
}

/// Looks through the centre of pixel (x, y) and notes what is there.
bool find_surface(const EmbreeScene& scene, const CameraFrame& frame, int x, int y, PrimaryHits& hits,
                  SurfaceHit& hit) {
    const Camera& camera = frame.camera();
    if (!scene.first_hit(frame.ray(x + 0.5, y + 0.5), camera.near, camera.far, hit)) return false;
    hits.surface.at(x, y) = 1;
    hits.depth.at(x, y) = static_cast<float>(hit.depth);
    hits.normal.at(x, y) = glm::vec3(glm::dmat3(frame.view_from_world()) * hit.normal);
    return true;
}

RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, int x, int y) {
    const glm::dvec3& axis = settings.shading_normals ? hit.shading_normal : hit.normal;
    const auto pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
    return {glm::vec3(hit.position + hit.offset_m * hit.normal), glm::mat3(frame_about(axis)),
            mix_bits(mix_bits(settings.seed) ^ pixel)};
}

}  // namespace

struct ReferenceScene::Impl {
    Impl(const Scene& scene, const TraceBuild& build) : embree(scene, build) {}
    EmbreeScene embree;
};

ReferenceScene::ReferenceScene(const Scene& scene, const TraceBuild& build)
    : impl_(std::make_unique<Impl>(scene, build)) {}
ReferenceScene::~ReferenceScene() = default;
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;
ReferenceScene& ReferenceScene::operator=(ReferenceScene&&) noexcept = default;

std::size_t ReferenceScene::peak_bytes() const {
    return impl_->embree.peak_bytes();
}

PrimaryHits ReferenceScene::primary_hits(const CameraFrame& frame) const {
    PrimaryHits hits = empty_hits(frame.width(), frame.height());
    const std::vector<Tile> tiles = tiles_of(frame.width(), frame.height());
    parallel_for(tiles.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const FlushDenormals flush;
        const Tile& tile = tiles[i];
        SurfaceHit hit;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) find_surface(impl_->embree, frame, x, y, hits, hit);
        }
    });
    return hits;
}

Truth ReferenceScene::trace(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                            const TruthSettings& settings, const std::string& what) const {
    check(queries, settings);
    const int width = frame.width(), height = frame.height();
    Truth truth;
    truth.hits = empty_hits(width, height);
    truth.queries = queries;
    truth.visibility.assign(queries.size(), ImageF(width, height, 1.0f));
    truth.standard_error.assign(queries.size(), ImageF(width, height, 0.0f));
    truth.samples = settings.samples;

    const std::vector<Tile> tiles = tiles_of(width, height);
    const PointSets points(settings.points, (settings.samples + kReplicates - 1) / kReplicates);
    Progress progress(what, tiles.size());
    std::atomic<std::uint64_t> rays{0};
    const auto start = std::chrono::steady_clock::now();
    parallel_for(tiles.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const FlushDenormals flush;
        const Tile& tile = tiles[i];
        std::vector<RaySource> sources;
        std::vector<std::size_t> pixels;
        SurfaceHit hit;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                if (!find_surface(impl_->embree, frame, x, y, truth.hits, hit)) continue;
                sources.push_back(ray_source(hit, settings, x, y));
                pixels.push_back(truth.hits.depth.index(x, y));
            }
        }
        TileTracer tracer(impl_->embree, queries, points);
        tracer.start(std::move(sources));
        tracer.trace(0, settings.samples);
        std::vector<PixelSpread> spreads(pixels.size());
        for (std::size_t q = 0; q < queries.size(); ++q) {
            for (std::size_t p = 0; p < pixels.size(); ++p) {
                spreads[p] = pixel_spread(tracer.sums(p, q), settings.samples);
            }
            const std::vector<Estimate> estimates = moderated_estimates(spreads);
            for (std::size_t p = 0; p < pixels.size(); ++p) {
                truth.visibility[q].pixels[pixels[p]] = static_cast<float>(estimates[p].visibility);
                truth.standard_error[q].pixels[pixels[p]] = static_cast<float>(estimates[p].standard_error);
            }
        }
        rays += tracer.rays();
        progress.step();
    });
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    truth.rays = rays;
    truth.seconds = elapsed.count();
    return truth;
}

}  // namespace aoscore
