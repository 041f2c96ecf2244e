#include "plan/claims/quantity.h"

#include "core/error.h"
#include "core/known_names.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/roles.h"
#include "plan/claims/block_draws.h"
#include "plan/claims/repeat_quantities.h"
#include "plan/claims/time_quantities.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

using namespace repeat_quantities;
using namespace time_quantities;

constexpr std::string_view kProcessor = "processor ms";
constexpr QuantityNeeds kTimes{.times = true};
constexpr QuantityNeeds kSeeds{.repeats = true};
constexpr QuantityNeeds kConverged{.repeats = true, .converged = true};
constexpr QuantityNeeds kRepeats{.repeats = true, .causes = true};
constexpr QuantityNeeds kBentWhereHidden{.repeats = true, .causes = true, .signal = "bent_normal"};
constexpr QuantityNeeds kConeWhereHidden{.repeats = true, .causes = true, .signal = "cone_angle"};
constexpr QuantityNeeds kLit{.lit_by_environment = true, .signal = "cone_angle"};
constexpr QuantityNeeds kOfBlocks{.regional = true};

std::optional<double> value_of(const MetricMap& metrics, const char* id) {
    const auto found = metrics.find(id);
    return found == metrics.end() ? std::nullopt : found->second.value;
}

Measured fetches(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    return exact(cell.fetches_per_pixel);
}
Measured gbuffer_bytes(const CellRecord& cell, const ViewRecord& view, std::uint64_t) {
    if (!cell.gbuffer_bytes) return {};
    return exact(*cell.gbuffer_bytes / (double{1} * view.width * view.height));
}
Measured layer_bytes(const CellRecord& cell, const ViewRecord& view, std::uint64_t) {
    if (!cell.layer_bytes) return {};
    return exact(*cell.layer_bytes / (double{1} * view.width * view.height));
}
// Draws are paired between the settings of one view, which draw the same blocks of the picture.
Measured of_blocks(const CellRecord& cell, const char* measure, std::uint64_t seed) {
    if (!cell.analysis) return {};
    const BlockErrors* const image = &cell.analysis->blocks;
    const double value = value_of_blocks(measure, *image);
    if (!std::isfinite(value)) return {};
    return {value, resampled(measure, BootstrapImages(&image, 1), seed)};
}

Measured rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return of_blocks(cell, kRankingMetric, seed);
}
Measured bias(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return of_blocks(cell, kBiasMetric, seed);
}
// The truth's noise, which is taken off, is taken as known.
Measured fitted_rmse(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    if (!cell.analysis || !cell.analysis->fit.rmse_debiased) return {};
    const BestFit& fit = cell.analysis->fit;
    const double noise = fit.rmse * fit.rmse - *fit.rmse_debiased * *fit.rmse_debiased;
    Measured measured = over_blocks(
        {&fit.squared_sums, &cell.analysis->blocks.counts},
        [noise](const auto& s) { return std::sqrt(std::max(s[0] / s[1] - noise, 0.0)); }, seed);
    measured.value = fit.rmse_debiased;
    return measured;
}
Measured missing_area(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return of_blocks(cell, kMissingArea, seed);
}
Measured false_area(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return of_blocks(cell, kFalseArea, seed);
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
Measured behind_edges(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    if (!cell.analysis || cell.analysis->behind_edges.counts.empty()) return {};
    const BinBlocks& behind = cell.analysis->behind_edges;
    return over_blocks(
        {&behind.signed_sums, &behind.counts}, [](const auto& s) { return s[0] / s[1]; }, seed);
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
constexpr char kLitByNormal[] = "rmse.normal", kLitByBentNormal[] = "rmse.bent_normal",
               kLitByCone[] = "rmse.cone", kLitByConeAlone[] = "rmse.cone_alone",
               kGainOfBentNormal[] = "gain.bent_normal", kGainOfCone[] = "gain.cone";

// The ends of the interval stand for its draws.
template <const char* Id>
Measured light(const CellRecord& cell, const ViewRecord&, std::uint64_t) {
    const auto found = cell.light.find(Id);
    if (found == cell.light.end()) return {};
    Measured measured = exact(found->second.value);
    if (const auto& interval = found->second.interval) measured.draws = {interval->low, interval->high};
    return measured;
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

Measured exact(std::optional<double> value) {
    return {value, {}};
}

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
        {"ao_ms", "AO pass", kProcessor, 2, ao_ms, kTimes},
        {"filter_ms", "filter", kProcessor, 2, filter_ms, kTimes},
        {"cost_ms", "AO pass and filter", kProcessor, 2, cost_ms, kTimes},
        {"filter_share", "filter's share of AO and filter", "", 3, filter_share, kTimes},
        {"filter_over_ao", "filter over AO pass", "", 3, filter_over_ao, kTimes},
        {"ms_per_fetch", "AO pass without its depth layers, for each fetch a pixel", kProcessor, 3, per_fetch,
         kTimes},
        {"relative_cost", "AO pass in fixed passes", "", 2, relative, kTimes},
        {"variation", "half the quartiles' distance over the median of the runs, at most", "", 3, variation,
         kTimes},
        {"lighting_ms", "lighting pass", kProcessor, 2, lighting_ms, {.lighting = true}},
        {"frame_ms", "lit frame", kProcessor, 2, frame_ms, {.lighting = true}},
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
        {"layer_bytes", "depth layers for each pixel of the picture", "bytes", 1, layer_bytes},
        {"gbuffer_bytes", "G-buffer for each pixel of the picture", "bytes", 1, gbuffer_bytes, kTimes},
        {"rmse", "RMSE", "", 4, rmse, kOfBlocks},
        {"unfiltered_rmse", "RMSE before the filter", "", 4, unfiltered<kRankingMetric>},
        {"bias", "bias", "", 4, bias, kOfBlocks},
        {"unfiltered_bias", "bias before the filter", "", 4, unfiltered<kBiasMetric>},
        {"ssim", "SSIM", "", 4, ranked<kStructureMetric>},
        {"flip", "FLIP", "", 4, ranked<kPerceptualMetric>},
        {"missing_area", "area of missing occlusion", "", 4, missing_area, kOfBlocks},
        {"fitted_rmse", "RMSE after the best fit", "", 4, fitted_rmse},
        {"tile_pattern", "error that repeats every 4 pixels", "", 4, tile_pattern},
        {"behind_edges", "bias on the far side of depth edges", "", 4, behind_edges},
        {"edge_bias", "bias beside depth edges", "", 4, edge_bias},
        {"edge_rmse", "RMSE beside depth edges", "", 4, edge_rmse},
        {"steep_rmse", "RMSE on the steepest surfaces", "", 4, steep_rmse},
        {"own_truth_brighter", "own truth less the binary one", "", 4, own_truth_brighter},
        {"ms_per_megapixel", "AO pass for a million shaded pixels", kProcessor, 2, per_megapixel, kTimes},
        {"false_area", "area of false occlusion", "", 4, false_area, kOfBlocks},
        {"darker_at_edges", "bias less that beside depth edges", "", 4, darker_at_edges},
        {"ao_processor_ms", "AO pass without its depth layers", kProcessor, 2, ao_without_layers_ms, kTimes},
        {"layers_processor_ms", "pass of depth layers", kProcessor, 2, layers_ms, kTimes},
        {"noise", "noise over seeds", "", 4, repeats_noise, kSeeds},
        {"raw_noise", "noise over seeds before the filter", "", 4, repeats_raw_noise, kSeeds},
        {"unconverged", "distance from the converged picture", "", 4, unconverged, kConverged},
        {"raw_unconverged", "distance from the converged picture before the filter", "", 4, raw_unconverged,
         kConverged},
        {"raw_unconverged_bands", "part of that distance that is alike over 4x4 pixels", "", 4,
         raw_unconverged_bands, kConverged},
        {"light_rmse_normal", "irradiance error by visibility and normal", "", 4, light<kLitByNormal>, kLit},
        {"light_rmse_bent_normal", "irradiance error by visibility and bent normal", "", 4,
         light<kLitByBentNormal>, kLit},
        {"light_rmse_cone", "irradiance error by visibility and bent cone", "", 4, light<kLitByCone>, kLit},
        {"light_rmse_cone_alone", "irradiance error by the bent cone alone", "", 4, light<kLitByConeAlone>,
         kLit},
        {"light_gain_bent_normal", "irradiance error by the normal less that by the bent normal", "", 4,
         light<kGainOfBentNormal>, kLit},
        {"light_gain_cone", "irradiance error by the bent normal less that by the bent cone", "", 4,
         light<kGainOfCone>, kLit},
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
