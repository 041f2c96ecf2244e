#include "jobs/truth_record.h"

#include "jobs/masked_mean.h"
#include "jobs/own_truth.h"
#include "jobs/truth_channels.h"
#include "jobs/truth_signals.h"
#include "metrics/measures/noise.h"
#include "reference/integrator/tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

bool is_untraced(const Truth& truth, const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (truth.sample_counts.at(x, y) > 0) return false;
        }
    }
    return true;
}

}  // namespace

TruthRecord query_record(const Truth& truth, std::size_t q, const Mask& valid) {
    const TruthQuery& query = truth.queries[q];
    TruthRecord record;
    record.id = truth_id(query);
    record.falloff = falloff_name(query.falloff);
    if (std::isfinite(query.radius_m)) record.radius_m = query.radius_m;
    if (query.falloff == Falloff::alchemy) record.u_m = query.u_m;
    record.samples = truth.samples;
    if (truth.standard_error[q].empty()) return record;
    const NoiseFloor floor = noise_floor(truth.standard_error[q], valid).value_or(NoiseFloor{});
    record.mean_standard_error = floor.mean_standard_error;
    record.noise_floor_rmse = floor.rmse();
    return record;
}

TruthSavings truth_savings(const Truth& truth) {
    TruthSavings savings;
    savings.left_out_triangles = truth.left_out_triangles;
    const std::vector<std::uint32_t>& counts = truth.sample_counts.pixels;
    savings.most_samples = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::uint64_t saved = savings.most_samples - counts[i];
        if (truth.hits.surface.pixels[i] == 0) {
            savings.background_rays += saved;
        } else if (counts[i] == 0) {
            savings.open_rays += saved;
        } else {
            savings.converged_rays += saved;
        }
    }
    for (const Tile& tile : tiles_of(truth.sample_counts.width, truth.sample_counts.height)) {
        ++savings.tiles;
        if (is_untraced(truth, tile)) ++savings.untraced_tiles;
    }
    return savings;
}

void record_truth(const Truth& truth, const Mask& valid, ViewRecord& view) {
    view.samples = truth.samples;
    view.open_pixels = truth.open_pixels;
    view.truth_seconds = truth.seconds;
    view.truth_rays = truth.rays;
    view.truth_rays_now = truth.rays_now;
    view.background_pixels = 0;
    for (const std::uint8_t surface : truth.hits.surface.pixels) view.background_pixels += surface == 0;
    view.savings = truth_savings(truth);
    for (std::size_t q = 0; q < truth.queries.size(); ++q) {
        TruthRecord& record = view.truths.emplace_back(query_record(truth, q, valid));
        if (q == 0) record.id = kRankedTruth;
        record.channel = query_channel(q);
        if (!truth.standard_error[q].empty()) record.se_channel = query_error_channel(q);
    }
    for (std::size_t c = 0; c < kCauses; ++c) {
        const ImageF& occlusion = truth.occlusion_by_cause[c];
        if (occlusion.empty()) continue;
        view.causes.push_back({std::string(kCauseIds[c]), truth_channel(cause_channel_id(c)).exr_names[0],
                               mean_over(occlusion, valid)});
    }
    view.signals = recorded_signals(truth, valid);
    if (!truth.one_layer_bound.empty()) view.one_layer_channel = truth_channel(kOneLayerId).exr_names[0];
}

}  // namespace aoscore
