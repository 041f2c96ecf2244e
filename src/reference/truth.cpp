#include "reference/truth.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/threads.h"
#include "reference/embree_scene.h"
#include "reference/flush_denormals.h"
#include "reference/tile.h"
#include "reference/tile_integrator.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

void check(const std::vector<TruthQuery>& queries, const TruthSettings& settings) {
    if (settings.samples < 1 || settings.samples > kMostSamples) {
        throw usage_error(fmt::format("{} samples a pixel", settings.samples), "samples",
                          fmt::format("1 to {}", kMostSamples));
    }
    if (!(settings.max_error >= 0 && settings.max_error < 1)) {
        throw usage_error(fmt::format("error of {}", settings.max_error), "error", "0 (off) or less than 1");
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

void make_room_for_extras(const TruthExtras& extras, Truth& truth) {
    const int width = truth.hits.surface.width, height = truth.hits.surface.height;
    if (extras.causes) truth.occlusion_by_cause.fill(ImageF(width, height, 0.0f));
    if (extras.one_layer_bound) truth.one_layer_bound = ImageF(width, height, 0.0f);
    if (extras.bent_normals) {
        truth.bent_normal = Image<glm::vec3>(width, height, glm::vec3(0));
        truth.cone_angle_rad = ImageF(width, height, 0.0f);
    }
}

int mean_samples(const Truth& truth) {
    std::uint64_t surfaces = 0, samples = 0;
    for (const std::uint8_t s : truth.hits.surface.pixels) surfaces += s;
    for (const std::uint32_t n : truth.sample_counts.pixels) samples += n;
    return surfaces == 0 ? 0 : static_cast<int>((samples + surfaces / 2) / surfaces);
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
    truth.sample_counts = Image<std::uint32_t>(width, height, 0);
    make_room_for_extras(settings.extras, truth);
    // What is hidden shows only once the whole picture is there.
    const bool judges = settings.extras.causes || settings.extras.one_layer_bound;
    const PrimaryHits shown = judges ? primary_hits(frame) : PrimaryHits{};
    const CauseJudge judge(impl_->embree, frame, shown);

    const std::vector<Tile> tiles = tiles_of(width, height);
    const PointSets points(settings.points, SamplePlan(settings).most());
    Progress progress(what, tiles.size());
    std::atomic<std::uint64_t> rays{0}, open_pixels{0};
    const auto start = std::chrono::steady_clock::now();
    const std::size_t group = tiles_at_a_time(tiles.size());
    parallel_for((tiles.size() + group - 1) / group, [&](std::size_t g) {
        const FlushDenormals flush;
        TileIntegrator integrator(impl_->embree, frame, queries, settings, points, judge);
        for (std::size_t i = g * group; i < std::min(tiles.size(), (g + 1) * group); ++i) {
            throw_if_interrupted();
            integrator.integrate(tiles[i], truth);
            progress.step();
        }
        rays += integrator.rays();
        open_pixels += integrator.open_pixels();
    });
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    truth.rays = rays;
    truth.open_pixels = open_pixels;
    truth.samples = settings.max_error > 0 ? mean_samples(truth) : settings.samples;
    truth.seconds = elapsed.count();
    return truth;
}

}  // namespace aoscore
