#include "reference/benchmark/random_tiles.h"

#include "core/sampling.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/tile_store.h"
#include "reference/integrator/truth_resolve.h"

#include <algorithm>

namespace aoscore {

RandomTiles::RandomTiles(const ReferenceScene& scene, const CameraFrame& frame, std::size_t groups)
    : scene_(scene), frame_(frame) {
    const std::size_t all = TileGroups(frame.width(), frame.height()).count();
    groups_ = numbers_up_to(all);
    std::sort(groups_.begin(), groups_.end(),
              [](std::size_t a, std::size_t b) { return mix_bits(a) < mix_bits(b); });
    groups_.resize(std::min(groups, all));
    part_ = static_cast<double>(groups_.size()) / static_cast<double>(all);
}

Truth RandomTiles::trace(const std::vector<TruthQuery>& queries, const TruthSettings& settings) const {
    const TileGroups groups(frame_.width(), frame_.height());
    const std::vector<GroupState> states = scene_.trace_groups(frame_, queries, settings, groups_);
    const std::vector<std::size_t> all = numbers_up_to(queries.size());
    Truth truth = empty_truth(frame_, queries, settings.extras);
    for (std::size_t i = 0; i < states.size(); ++i) {
        resolve_group(groups, groups_[i], states[i].tiles, frame_, {queries.size(), all, settings}, truth);
    }
    count_samples(settings, truth);
    return truth;
}

double mean_standard_error(const Truth& truth) {
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        sum += truth.standard_error[0].pixels[i];
        pixels += truth.hits.surface.pixels[i];
    }
    return pixels > 0 ? sum / pixels : 0;
}

}  // namespace aoscore
