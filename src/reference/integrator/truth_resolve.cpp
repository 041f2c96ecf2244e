#include "reference/integrator/truth_resolve.h"

#include "core/interrupt.h"
#include "core/threads.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace aoscore {
namespace {

void make_room_for_extras(const TruthExtras& extras, Truth& truth) {
    const int width = truth.hits.surface.width, height = truth.hits.surface.height;
    if (extras.causes) truth.occlusion_by_cause.fill(ImageF(width, height, 0.0f));
    if (extras.one_layer_bound) truth.one_layer_bound = ImageF(width, height, 0.0f);
    if (extras.bent_normals) {
        truth.bent_normal = Image<glm::vec3>(width, height, glm::vec3(0));
        for (ImageF* image : {&truth.bent_error_rad, &truth.cone_angle_rad, &truth.cone_error_rad})
            *image = ImageF(width, height, 0.0f);
    }
}

}  // namespace

PrimaryHits empty_hits(int width, int height) {
    return {Mask(width, height), ImageF(width, height), Image<glm::vec3>(width, height, glm::vec3(0))};
}

Truth empty_truth(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                  const TruthExtras& extras) {
    const int width = frame.width(), height = frame.height();
    Truth truth;
    truth.hits = empty_hits(width, height);
    truth.queries = queries;
    truth.visibility.assign(queries.size(), ImageF(width, height, 1.0f));
    truth.standard_error.assign(queries.size(), ImageF(width, height, 0.0f));
    truth.sample_counts = Image<std::uint32_t>(width, height, 0);
    make_room_for_extras(extras, truth);
    return truth;
}

void count_samples(const TruthSettings& settings, Truth& truth) {
    std::uint64_t surfaces = 0;
    truth.rays = truth.open_pixels = 0;
    for (std::size_t i = 0; i < truth.sample_counts.size(); ++i) {
        if (truth.hits.surface.pixels[i] == 0) continue;
        ++surfaces;
        truth.rays += truth.sample_counts.pixels[i];
        truth.open_pixels += truth.sample_counts.pixels[i] == 0;
    }
    truth.samples = settings.samples;
    if (settings.mean_error > 0 && truth.rays > 0)
        truth.samples = static_cast<int>(*std::ranges::max_element(truth.sample_counts.pixels));
    if (settings.max_error > 0)
        truth.samples = surfaces == 0 ? 0 : static_cast<int>((truth.rays + surfaces / 2) / surfaces);
}

std::vector<std::size_t> numbers_up_to(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

void resolve_group(const TileGroups& groups, std::size_t g, const std::vector<TileState>& tiles,
                   const CameraFrame& frame, const ResolveRequest& request, Truth& truth) {
    for (std::size_t i = 0; i < groups.group(g).size(); ++i) {
        resolve_tile(groups.group(g)[i], tiles[i], frame, request, truth);
    }
}

void resolve_kept(const TileGroups& groups, const std::vector<std::size_t>& kept, const TileStore& store,
                  const CameraFrame& frame, const ResolveRequest& request, Truth& truth) {
    std::atomic<double> seconds{0};
    parallel_for(kept.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const GroupState state = store.load(kept[i]);
        resolve_group(groups, kept[i], state.tiles, frame, request, truth);
        seconds += state.seconds;
    });
    truth.seconds += seconds / thread_count();
}

Truth kept_truth(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                 const TruthSettings& settings, const std::vector<std::size_t>& which,
                 const TruthExtras& extras, const TileStore& store) {
    std::vector<TruthQuery> wanted;
    for (const std::size_t q : which) wanted.push_back(queries[q]);
    Truth truth = empty_truth(frame, wanted, extras);
    const TileGroups groups(frame.width(), frame.height());
    resolve_kept(groups, numbers_up_to(groups.count()), store, frame, {queries.size(), which, settings},
                 truth);
    count_samples(settings, truth);
    return truth;
}

}  // namespace aoscore
