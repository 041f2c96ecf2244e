#include "plan/claims/time_quantities.h"

#include "core/sampling.h"
#include "metrics/intervals/median_interval.h"
#include "results/layer_times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace aoscore::time_quantities {
namespace {

constexpr std::size_t kDraws = 2000;

std::mt19937_64 stream_of(const std::string& name, std::uint64_t seed) {
    for (const char c : name) seed = mix_bits(seed ^ static_cast<unsigned char>(c));
    return std::mt19937_64(seed);
}

std::vector<double> redrawn(const std::vector<double>& runs, std::mt19937_64& random) {
    std::vector<double> drawn(runs.size());
    for (double& run : drawn) run = runs[random() % runs.size()];
    return drawn;
}

// Draws medians of resampled runs (Efron and Tibshirani, An Introduction to the Bootstrap, 1993), each as
// another load of the machine could have it. Fewer than two runs say nothing of how far they scatter.
Measured timed(const std::vector<double>& runs_ms, const std::string& name, std::uint64_t seed) {
    if (runs_ms.size() < 2) return {};
    Measured measured = exact(median(runs_ms));
    std::mt19937_64 random = stream_of(name, seed);
    std::normal_distribution<double> load(0, kLoadSpread);
    for (std::size_t i = 0; i < kDraws; ++i) {
        const double drawn = median(redrawn(runs_ms, random));
        measured.draws.push_back(drawn * std::exp(load(random)));
    }
    return measured;
}

double sum(const std::vector<double>& v) {
    return v[0] + v[1];
}
double quotient(const std::vector<double>& v) {
    return v[0] / v[1];
}

// The time of a frame without AO.
Measured geometry_lighting_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    const bool own = !cell.gbuffer.processor_runs_ms.empty();
    const Timing& gbuffer = own ? cell.gbuffer : view.gbuffer;
    const std::string& name = own ? cell.id : view.key;
    return combined(
        {timed(gbuffer.processor_runs_ms, name + " G-buffer", seed), lighting_ms(cell, view, seed)}, sum);
}

// Half the distance between the quartiles over the median.
double relative_spread(std::vector<double> runs) {
    std::sort(runs.begin(), runs.end());
    const auto at = [&](double q) {
        return runs[static_cast<std::size_t>(q * static_cast<double>(runs.size() - 1) + 0.5)];
    };
    return (at(0.75) - at(0.25)) / 2 / median(runs);
}

}  // namespace

Measured ao_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.ao.processor_runs_ms, cell.id, seed);
}
Measured ao_without_layers_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(runs_without_layers_ms(cell), cell.id, seed);
}
Measured layers_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.layers_processor.runs_ms, cell.id + " layers", seed);
}
Measured filter_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.filter_pass.processor_runs_ms, cell.id + " filter", seed);
}
Measured cost_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    if (cell.filter_pass.processor_runs_ms.empty()) return ao_ms(cell, view, seed);
    return combined({ao_ms(cell, view, seed), filter_ms(cell, view, seed)}, sum);
}
Measured filter_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({filter_ms(cell, view, seed), cost_ms(cell, view, seed)}, quotient);
}
Measured filter_over_ao(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({filter_ms(cell, view, seed), ao_ms(cell, view, seed)}, quotient);
}
Measured per_fetch(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_without_layers_ms(cell, view, seed), exact(cell.fetches_per_pixel)}, quotient);
}
Measured per_megapixel(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), exact(static_cast<double>(view.valid_pixels) / 1e6)}, quotient);
}
Measured relative(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined(
        {ao_ms(cell, view, seed), timed(cell.fixed_pass.processor_runs_ms, cell.id + " fixed pass", seed)},
        quotient);
}
Measured lighting_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.lighting.processor_runs_ms, cell.id + " lighting", seed);
}
Measured frame_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), geometry_lighting_ms(cell, view, seed)}, sum);
}
Measured cost_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), frame_ms(cell, view, seed)}, quotient);
}
Measured cost_over_rest(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), geometry_lighting_ms(cell, view, seed)}, quotient);
}
Measured filter_over_lighting(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({filter_ms(cell, view, seed), lighting_ms(cell, view, seed)}, quotient);
}
Measured waiting(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return combined({timed(cell.frame_by_pass.processor_runs_ms, cell.id + " by pass", seed),
                     timed(cell.frame_at_once.processor_runs_ms, cell.id + " at once", seed)},
                    quotient);
}
// How much of it is the machine's load is not known: between all and none.
Measured variation(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    const std::vector<double>& runs_ms = cell.ao.processor_runs_ms;
    if (runs_ms.size() < 2) return {};
    Measured measured = exact(relative_spread(runs_ms));
    std::mt19937_64 random = stream_of(cell.id + " variation", seed);
    for (std::size_t i = 0; i < kDraws / 2; ++i) {
        measured.draws.push_back(relative_spread(redrawn(runs_ms, random)));
        measured.draws.push_back(0);
    }
    return measured;
}

}  // namespace aoscore::time_quantities
