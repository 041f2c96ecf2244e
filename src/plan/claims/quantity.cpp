#include "plan/claims/quantity.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/sampling.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/intervals/median_interval.h"
#include "metrics/roles.h"
#include "plan/claims/repeat_quantities.h"
#include "results/layer_times.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace aoscore {
namespace {

using namespace repeat_quantities;

constexpr QuantityNeeds kTimes{.times = true};
constexpr QuantityNeeds kRepeats{.repeats = true};
constexpr QuantityNeeds kBentWhereHidden{.repeats = true, .signal = "bent_normal"};
constexpr QuantityNeeds kConeWhereHidden{.repeats = true, .signal = "cone_angle"};

constexpr std::size_t kDraws = 2000;

// Draws medians of resampled runs (Efron and Tibshirani, An Introduction to the Bootstrap, 1993).
Measured timed(const Timing& timing, const std::string& name, std::uint64_t seed) {
    Measured measured{timing.median_ms, {}};
    const std::vector<double>& runs = timing.runs_ms;
    if (!timing.median_ms || runs.size() < 2) return measured;
    std::uint64_t stream = seed;
    for (const char c : name) stream = mix_bits(stream ^ static_cast<unsigned char>(c));
    std::mt19937_64 random(stream);
    std::vector<double> drawn(runs.size());
    for (std::size_t i = 0; i < kDraws; ++i) {
        for (double& run : drawn) run = runs[random() % runs.size()];
        measured.draws.push_back(median(drawn));
    }
    return measured;
}

Measured exact(std::optional<double> value) {
    return {value, {}};
}

std::optional<double> value_of(const MetricMap& metrics, const char* id) {
    const auto found = metrics.find(id);
    return found == metrics.end() ? std::nullopt : found->second.value;
}

Measured ao_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.ao, cell.id, seed);
}
Measured filter_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.filter_pass, cell.id + " filter", seed);
}
Measured cost_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    if (!cell.filter_pass.median_ms) return ao_ms(cell, view, seed);
    return combined({ao_ms(cell, view, seed), filter_ms(cell, view, seed)},
                    [](const auto& v) { return v[0] + v[1]; });
}
Measured filter_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), filter_ms(cell, view, seed)},
                    [](const auto& v) { return v[1] / (v[0] + v[1]); });
}
Measured filter_over_ao(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), filter_ms(cell, view, seed)},
                    [](const auto& v) { return v[1] / v[0]; });
}
Measured per_fetch(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), exact(cell.fetches_per_pixel)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured relative(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), exact(cell.fixed_pass_ms)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured lighting_ms(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.lighting, cell.id + " lighting", seed);
}
// The time of a frame without AO.
Measured geometry_lighting_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    const bool own = !cell.gbuffer.runs_ms.empty();
    const Measured gbuffer = own ? timed(cell.gbuffer, cell.id + " G-buffer", seed)
                                 : timed(view.gbuffer, view.key + " G-buffer", seed);
    return combined({gbuffer, lighting_ms(cell, view, seed)}, [](const auto& v) { return v[0] + v[1]; });
}
Measured frame_ms(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), geometry_lighting_ms(cell, view, seed)},
                    [](const auto& v) { return v[0] + v[1]; });
}
Measured cost_share(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), geometry_lighting_ms(cell, view, seed)},
                    [](const auto& v) { return v[0] / (v[0] + v[1]); });
}
Measured cost_over_rest(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({cost_ms(cell, view, seed), geometry_lighting_ms(cell, view, seed)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured filter_over_lighting(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({filter_ms(cell, view, seed), lighting_ms(cell, view, seed)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured waiting(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return combined({timed(cell.frame_by_pass, cell.id + " by pass", seed),
                     timed(cell.frame_at_once, cell.id + " at once", seed)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured ao_processor(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    Timing apart;
    apart.runs_ms = runs_without_layers_ms(cell);
    if (apart.runs_ms.empty()) return {};
    apart.median_ms = median(apart.runs_ms);
    return timed(apart, cell.id, seed);
}
Measured layers_processor(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.layers_processor, cell.id + " layers", seed);
}
Measured cost_processor(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return timed(cell.ao_processor, cell.id, seed);
}
Measured processor_per_fetch(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_processor(cell, view, seed), exact(cell.fetches_per_pixel)},
                    [](const auto& v) { return v[0] / v[1]; });
}
Measured variation(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    const std::vector<double>& runs = cell.ao.runs_ms;
    if (runs.size() < 2 || !cell.ao.spread_ms || !cell.ao.median_ms) return {};
    return exact(*cell.ao.spread_ms / *cell.ao.median_ms);
}
Measured fetches(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.fetches_per_pixel);
}
// Draws are paired between the settings of one view, which draw the same blocks of the picture.
Measured analysed(const CellRecord& cell, const char* metric, std::uint64_t seed) {
    const auto found = cell.ranked.find(metric);
    if (found == cell.ranked.end() || !found->second.value || !cell.analysis) return {};
    const BlockErrors* const image = &cell.analysis->blocks;
    return {found->second.value, resampled(metric, BootstrapImages(&image, 1), seed)};
}

Measured rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return analysed(cell, kRankingMetric, seed);
}
Measured bias(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return analysed(cell, kBiasMetric, seed);
}
Measured fitted_rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.analysis ? cell.analysis->fit.rmse_debiased : std::nullopt);
}
Measured missing_area(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.analysis ? std::optional(cell.analysis->missing.area) : std::nullopt);
}
Measured false_area(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.analysis ? std::optional(cell.analysis->false_occlusion.area) : std::nullopt);
}

// Occlusion over the truth's: the bias is what it lacks of it.
Measured share_of_truth(const CellRecord& cell, const ViewRecord& view, std::uint64_t) {
    double occlusion = 0;
    for (const CauseRecord& cause : view.causes) occlusion += cause.mean_occlusion;
    return combined({exact(value_of(cell.ranked, kBiasMetric))},
                    [occlusion](const auto& v) { return 1 - v[0] / occlusion; });
}
Measured tile_pattern(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.analysis ? cell.analysis->tile_pattern : std::nullopt);
}

const SplitBin* first_bin(const CellRecord& cell, std::string_view split_id) {
    if (!cell.analysis) return nullptr;
    for (const Split& split : cell.analysis->splits) {
        if (split.id == split_id && !split.bins.empty()) return &split.bins.front();
    }
    return nullptr;
}
Measured edge_bias(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    const SplitBin* bin = first_bin(cell, "edge_distance");
    return exact(bin != nullptr ? bin->bias : std::nullopt);
}
Measured edge_rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    const SplitBin* bin = first_bin(cell, "edge_distance");
    return exact(bin != nullptr ? bin->rmse : std::nullopt);
}
Measured darker_at_edges(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({exact(value_of(cell.ranked, kBiasMetric)), edge_bias(cell, view, seed)},
                    [](const auto& v) { return v[0] - v[1]; });
}
Measured steep_rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    const SplitBin* bin = first_bin(cell, "tilt");
    return exact(bin != nullptr ? bin->rmse : std::nullopt);
}
// The difference in brightness between the method's own truth and the ranking's; the tested image cancels.
Measured own_truth_brighter(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return combined({exact(value_of(cell.ranked, kBiasMetric)), exact(value_of(cell.own, kBiasMetric))},
                    [](const auto& v) { return v[0] - v[1]; });
}
Measured per_megapixel(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed) {
    return combined({ao_ms(cell, view, seed), exact(static_cast<double>(view.valid_pixels) / 1e6)},
                    [](const auto& v) { return v[0] / v[1]; });
}

template <const char* Id>
Measured ranked(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(value_of(cell.ranked, Id));
}
template <const char* Id>
Measured unfiltered(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(value_of(cell.raw.empty() ? cell.ranked : cell.raw, Id));
}

}  // namespace

std::optional<Measured::Range> Measured::range() const {
    if (!value) return std::nullopt;
    if (draws.empty()) return Range{*value, *value};
    std::vector<double> sorted = draws;
    if (!std::all_of(sorted.begin(), sorted.end(), [](double d) { return std::isfinite(d); }))
        return std::nullopt;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double q) {
        return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5)];
    };
    return Range{at(0.025), at(0.975)};
}

Measured combined(const std::vector<Measured>& of,
                  const std::function<double(const std::vector<double>&)>& f) {
    Measured result;
    std::vector<double> values;
    std::size_t draws = 0;
    for (const Measured& one : of) {
        if (!one.value) return result;
        values.push_back(*one.value);
        draws = std::max(draws, one.draws.size());
    }
    const double value = f(values);
    if (!std::isfinite(value)) return result;
    result.value = value;
    for (std::size_t i = 0; i < draws; ++i) {
        for (std::size_t k = 0; k < of.size(); ++k) {
            if (i < of[k].draws.size()) values[k] = of[k].draws[i];
        }
        result.draws.push_back(f(values));
    }
    return result;
}

const std::vector<Quantity>& quantities() {
    static const std::vector<Quantity> table = {
        {"ao_ms", "AO pass", "ms", 2, ao_ms, kTimes},
        {"filter_ms", "filter", "ms", 2, filter_ms, kTimes},
        {"cost_ms", "AO pass and filter", "ms", 2, cost_ms, kTimes},
        {"filter_share", "filter's share of AO and filter", "", 3, filter_share, kTimes},
        {"filter_over_ao", "filter over AO pass", "", 3, filter_over_ao, kTimes},
        {"ms_per_fetch", "AO pass for each fetch a pixel", "ms", 3, per_fetch, kTimes},
        {"relative_cost", "AO pass in fixed passes", "", 2, relative, kTimes},
        {"variation", "half the quartiles' distance over the median of the runs", "", 3, variation, kTimes},
        {"lighting_ms", "lighting pass", "ms", 2, lighting_ms, {.lighting = true}},
        {"frame_ms", "lit frame", "ms", 2, frame_ms, {.lighting = true}},
        {"cost_share", "share of AO and filter in a lit frame", "", 3, cost_share, {.lighting = true}},
        {"cost_over_rest",
         "AO and filter over geometry and lighting",
         "",
         3,
         cost_over_rest,
         {.lighting = true}},
        {"filter_over_lighting",
         "filter over lighting pass",
         "",
         3,
         filter_over_lighting,
         {.lighting = true}},
        {"waiting",
         "frame waited for after every pass over one waited for at its end",
         "",
         3,
         waiting,
         {.whole_frames = true}},
        {"fetches", "fetches a pixel", "", 1, fetches},
        {"rmse", "RMSE", "", 4, rmse},
        {"unfiltered_rmse", "RMSE before the filter", "", 4, unfiltered<kRankingMetric>},
        {"bias", "bias", "", 4, bias},
        {"unfiltered_bias", "bias before the filter", "", 4, unfiltered<kBiasMetric>},
        {"ssim", "SSIM", "", 4, ranked<kStructureMetric>},
        {"flip", "FLIP", "", 4, ranked<kPerceptualMetric>},
        {"missing_area", "area of missing occlusion", "", 4, missing_area},
        {"fitted_rmse", "RMSE after the best fit", "", 4, fitted_rmse},
        {"tile_pattern", "error that repeats every 4 pixels", "", 4, tile_pattern},
        {"edge_bias", "bias beside depth edges", "", 4, edge_bias},
        {"edge_rmse", "RMSE beside depth edges", "", 4, edge_rmse},
        {"steep_rmse", "RMSE on the steepest surfaces", "", 4, steep_rmse},
        {"own_truth_brighter", "own truth less the binary one", "", 4, own_truth_brighter},
        {"ms_per_megapixel", "AO pass for a million shaded pixels", "ms", 2, per_megapixel, kTimes},
        {"false_area", "area of false occlusion", "", 4, false_area},
        {"darker_at_edges", "bias less that beside depth edges", "", 4, darker_at_edges},
        {"ao_processor_ms", "AO pass without its depth layers, processor time", "processor ms", 2,
         ao_processor, kTimes},
        {"layers_processor_ms", "pass of depth layers, processor time", "processor ms", 2, layers_processor,
         kTimes},
        {"cost_processor_ms", "AO pass and its depth layers, processor time", "processor ms", 2,
         cost_processor, kTimes},
        {"processor_ms_per_fetch", "AO pass without its depth layers, for each fetch a pixel", "processor ms",
         3, processor_per_fetch, kTimes},
        {"noise", "noise over seeds", "", 4, repeats_noise, kRepeats},
        {"raw_noise", "noise over seeds before the filter", "", 4, repeats_raw_noise, kRepeats},
        {"fitted_noise", "noise over seeds at the fitted strength", "", 4, repeats_fitted_noise, kRepeats},
        {"truth_found", "part of the truth's hidden occlusion that is found at the fitted strength", "", 3,
         found_of_truth, kRepeats},
        {"truth_share", "mean occlusion over the truth's", "", 3, share_of_truth, kRepeats},
        {"grazing_found",
         "part of the truth's occlusion by surfaces at a grazing angle that is found at the fitted strength",
         "", 3, found_of_grazing, kRepeats},
        {"truth_unevenness",
         "standard deviation over pixels of the part of the truth's hidden occlusion that is found, over its "
         "mean",
         "", 3, unevenness_of_truth, kRepeats},
        {"grazing_unevenness", "the same of occlusion by surfaces at a grazing angle", "", 3,
         unevenness_of_grazing, kRepeats},
        {"layers_found", "part that is found of what the first layer hides", "", 3, found_of_layers,
         kRepeats},
        {"layers_found_fitted", "part that is found of what the first layer hides, at the fitted strength",
         "", 3, found_fitted_of_layers, kRepeats},
        {"layers_kept", "part that is kept of what the first layer shows", "", 3, kept_of_layers, kRepeats},
        {"layers_finders", "part of the pixels with hidden occlusion where a fifth of it is found", "", 3,
         finders_of_layers, kRepeats},
        {"hidden_bent_angle", "mean angle between bent normals where occlusion is hidden", "°", 2,
         hidden_bent_angle, kBentWhereHidden},
        {"other_bent_angle", "mean angle between bent normals where none is hidden", "°", 2, other_bent_angle,
         kBentWhereHidden},
        {"hidden_cone_error", "mean error of the cone where occlusion is hidden", "°", 2, hidden_cone_error,
         kConeWhereHidden},
        {"hidden_cone_bias", "cone too wide where occlusion is hidden", "°", 2, hidden_cone_bias,
         kConeWhereHidden},
        {"other_cone_error", "mean error of the cone where none is hidden", "°", 2, other_cone_error,
         kConeWhereHidden},
    };
    return table;
}

const Quantity& find_quantity(std::string_view id, const std::string& where) {
    return row_in_file(quantities(), id, where);
}

}  // namespace aoscore
