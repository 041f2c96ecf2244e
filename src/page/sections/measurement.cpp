#include "core/counted.h"
#include "metrics/metric.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "results/lengths_text.h"
#include "results/view_piece.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

/// A line of a list of facts.
json fact(const std::string& name, const std::string& value) {
    return {{"name", name}, {"value", value}};
}

std::string point_text(const std::vector<double>& point) {
    std::vector<std::string> numbers;
    for (const double number : point) numbers.push_back(short_text(number));
    return fmt::format("({})", fmt::join(numbers, ", "));
}

std::string camera_text(const ViewRecord& view) {
    const std::string lens = view.projection == "orthographic"
                                 ? fmt::format("half height {} m", short_text(view.half_height_m))
                                 : fmt::format("vertical field of view {}°", short_text(view.fovy_deg));
    return fmt::format("{} from {} to {}, up {}, {}, near {} m, far {} m", view.projection,
                       point_text(view.position_m), point_text(view.target_m), point_text(view.up), lens,
                       short_text(view.near_m), short_text(view.far_m));
}

std::string contract_text(const ViewRecord& view) {
    const auto compared =
        static_cast<double>(view.valid_pixels) + static_cast<double>(view.disagreeing_pixels);
    const auto share = ratio(static_cast<double>(view.disagreeing_pixels), compared);
    return fmt::format(
        "ray tracer and rasteriser see the same surface in {} of {} surface pixels, which are the valid "
        "ones. "
        "Away from the {} edge pixels, {} disagree: {} %, where more than 0.5 % would fail the cells.",
        count_text(view.valid_pixels), count_text(view.surface_pixels), count_text(view.edge_pixels),
        count_text(view.disagreeing_pixels), percent_text(share, 3));
}

std::string truth_cost_text(const ViewRecord& view) {
    std::string text =
        fmt::format("{} samples a pixel{}", view.samples, view.halves ? " in two independent halves" : "");
    if (view.max_error)
        text +=
            fmt::format(" in the mean, traced until the standard error is {}", short_text(*view.max_error));
    text += fmt::format(", {} rays in {} s", count_text(view.truth_rays), fixed_text(view.truth_seconds, 1));
    if (view.open_pixels > 0) {
        text += fmt::format("; {} pixels were proven open without a ray", count_text(view.open_pixels));
    }
    if (view.truth_rays_now == 0) {
        text += "; all of them were traced by an earlier run";
    } else if (view.truth_rays_now < view.truth_rays) {
        text += fmt::format("; {}: {} of the rays were traced in this run", view.truth_origin,
                            count_text(view.truth_rays_now));
    }
    return text;
}

/// The rays that were saved, of all that the picture would have taken, and the triangles not built for
/// tracing.
std::string savings_text(const ViewRecord& view) {
    const TruthSavings& saved = view.savings;
    const auto all = static_cast<double>(view.truth_rays) + static_cast<double>(saved.background_rays) +
                     static_cast<double>(saved.open_rays) + static_cast<double>(saved.converged_rays);
    const auto share = [&](std::uint64_t rays) {
        return percent_text(ratio(static_cast<double>(rays), all), 1);
    };
    std::string text = fmt::format(
        "against {} rays for every pixel, {} % were saved: {} % on pixels without surface, {} % on pixels "
        "proven open, {} % on pixels that were sure enough earlier. {} of {} tiles needed no ray.",
        count_text(saved.most_samples), share(saved.background_rays + saved.open_rays + saved.converged_rays),
        share(saved.background_rays), share(saved.open_rays), share(saved.converged_rays),
        count_text(saved.untraced_tiles), count_text(saved.tiles));
    if (saved.left_out_triangles > 0) {
        text += fmt::format(" {} of {} triangles lay out of reach and were not built for tracing.",
                            count_text(saved.left_out_triangles), count_text(view.triangles));
    }
    return text;
}

/// The settings that a truth depends on, without scene, camera and radii, which have their own lines.
std::string truth_settings_text(const ViewRecord& view, std::uint64_t seed) {
    const std::string effort =
        view.max_error ? fmt::format("at least {} samples a pixel, then more until the standard error is {}",
                                     view.least_samples, short_text(*view.max_error))
        : view.score_error
            ? fmt::format(
                  "{} samples a pixel, then more until the truth's noise leaves every RMSE within {}{}",
                  view.least_samples, short_text(*view.score_error),
                  view.final_answer ? " and every other metric within five times that"
                                    : ", or the order of the ranking sure")
            : fmt::format("{} samples a pixel, without a bound on the error", view.least_samples);
    return fmt::format("seed {}, {}; integrator {}", seed, effort, view.integrator);
}

/// The rows of methods' lengths, each setting once.
json length_rows(const Results& results, const ViewRecord& view) {
    json rows = json::array();
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key != view.key || cell.lengths.empty()) continue;
        json row = {{"method", fmt::format("{}, {}", cell.method_label, cell.preset)},
                    {"filter", cell.filter},
                    {"lengths", lengths_text(cell)}};
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
    }
    return rows;
}

/// How the view came about: drawn and traced from its scene.
json facts_of_scene(const Results& results, const ViewRecord& view) {
    return json::array({
        fact("Size",
             fmt::format("{}×{} pixels, {} triangles", view.width, view.height, count_text(view.triangles))),
        fact("Camera", camera_text(view)),
        fact("Camera contract", contract_text(view)),
        fact("AO radius", radius_text(view)),
        fact("Truth", truth_cost_text(view)),
        fact("Truth's settings", truth_settings_text(view, results.seed)),
        fact("Rays saved", savings_text(view)),
        fact("G-buffer", fmt::format("{} ms, median of {} runs", fixed_text(view.gbuffer.median_ms, 1),
                                     view.gbuffer.runs_ms.size())),
    });
}

/// The same of a frame whose G-buffer and truth are files.
json facts_of_frame(const ViewRecord& view) {
    return json::array({
        fact("Size", fmt::format("{}×{} pixels, a frame without its scene", view.width, view.height)),
        fact("Camera", camera_text(view)),
        fact("Pixels that count",
             fmt::format("{} of {} with a surface, where the truth has a value",
                         count_text(view.valid_pixels), count_text(view.surface_pixels))),
        fact("AO radius", radius_text(view)),
        fact("Truth", "read from a file; " + std::string(view.halves ? "the mean of two renderings, whose "
                                                                       "difference tells its noise"
                                                                     : "one picture")),
    });
}

json view_model(const Results& results, const ViewRecord& view) {
    const bool given = view.truth_origin == "given";
    json facts = given ? facts_of_frame(view) : facts_of_scene(results, view);
    if (!view.scene_digest.empty()) facts.push_back(fact("Scene's digest", view.scene_digest));
    if (!view.view_source.empty()) facts.push_back(fact("View from", view.view_source));
    if (!view.view_note.empty()) facts.push_back(fact("Note", view.view_note));
    json truths = json::array();
    for (const TruthRecord& truth : view.truths) {
        const bool unknown = given && truth.se_channel.empty();
        truths.push_back({{"id", truth.id},
                          {"text", truth_text(truth)},
                          {"mean_error", unknown ? "unknown" : fixed_text(truth.mean_standard_error, 4)},
                          {"floor", unknown ? "unknown" : fixed_text(truth.noise_floor_rmse, 4)}});
    }
    json lengths = length_rows(results, view);
    return {{"key", view.key},
            {"facts", std::move(facts)},
            {"truths", std::move(truths)},
            {"has_lengths", !lengths.empty()},
            {"lengths", std::move(lengths)},
            {"truth_command", view.truth_command},
            {"piece", view_piece(view).dump()}};
}

json machine_facts(const Results& results) {
    return json::array({
        fact("Program", "aoscore " + results.program_version),
        fact("Made", results.created_utc),
        fact("Processor", fmt::format("{}, {} threads", results.cpu, results.threads)),
        fact("GL renderer", results.gl_renderer),
        fact("GL version", results.gl_version),
        fact("Seed", std::to_string(results.seed)),
        fact("Whole run", fmt::format("{} s, at most {} MiB of memory", fixed_text(results.total_seconds, 1),
                                      fixed_text(results.peak_memory_mib, 0))),
    });
}

json timing_rows(const Results& results) {
    json rows = json::array();
    for (const CellRecord& cell : results.cells) {
        if (!cell.error.empty()) continue;
        const int decimals = column_decimals({cell.ao.median_ms, cell.filter_pass.median_ms});
        const auto runs_text = [&](const Timing& timing) {
            std::vector<std::string> runs;
            for (const double run : timing.runs_ms) runs.push_back(fixed_text(run, decimals));
            return runs.empty() ? std::string(kNoNumber) : fmt::format("{}", fmt::join(runs, "  "));
        };
        rows.push_back({{"cell", cell.id},
                        {"ao", fixed_text(cell.ao.median_ms, decimals)},
                        {"ao_spread", fixed_text(cell.ao.spread_ms, decimals)},
                        {"ao_runs", runs_text(cell.ao)},
                        {"filter", fixed_text(cell.filter_pass.median_ms, decimals)},
                        {"filter_spread", fixed_text(cell.filter_pass.spread_ms, decimals)},
                        {"filter_runs", runs_text(cell.filter_pass)}});
    }
    return rows;
}

json metric_rows() {
    json rows = json::array();
    for (const Metric& metric : metrics()) {
        const char* better = metric.better == Metric::Better::lower    ? "lower is better"
                             : metric.better == Metric::Better::higher ? "higher is better"
                                                                       : "nearer to 0 is better";
        rows.push_back({{"label", std::string(metric.label)},
                        {"unit", std::string(metric.unit)},
                        {"has_unit", !metric.unit.empty()},
                        {"better", better},
                        {"meaning", std::string(metric.meaning)},
                        {"has_paper", !metric.paper.empty()},
                        {"paper", std::string(metric.paper)}});
    }
    return rows;
}

std::string visibility_levels_text(const Pictures& pictures) {
    const bool exact = !pictures.views.empty() && pictures.views.begin()->second.truth.bytes == 2;
    return count_text(static_cast<std::size_t>(exact ? kLevelsOfTwoBytes : kLevelsOfOneByte));
}

/// Says how many rays the truths have, what drew the methods, and whether anything was warned of.
std::string measurement_in_short(const Results& results, std::size_t warnings) {
    const bool given = std::ranges::any_of(
        results.views, [](const ViewRecord& view) { return view.truth_origin == "given"; });
    std::string rays;
    if (!results.views.empty() && !given) {
        const auto [least, most] = std::ranges::minmax(results.views, {}, &ViewRecord::samples);
        rays = fmt::format(" with {}{} rays a pixel", least.samples,
                           least.samples == most.samples ? "" : fmt::format(" to {}", most.samples));
    }
    const std::string warned = warnings == 0 ? "No warning was given."
                                             : counted(warnings, "warning was", "warnings were") + " given.";
    const std::string truths = counted(results.views.size(), "truth", "truths");
    return fmt::format("{}; {} drew the methods. {}",
                       given ? truths + (results.views.size() == 1 ? " was" : " were") + " read from files"
                             : "Embree traced " + truths + rays,
                       results.gl_renderer, warned);
}

}  // namespace

nlohmann::json section::measurement(const PageSource& source) {
    const Results& results = source.results;
    json views = json::array(), warnings = json::array();
    for (const ViewRecord& view : results.views) {
        views.push_back(view_model(results, view));
        for (const std::string& warning : view.warnings) warnings.push_back(view.key + ": " + warning);
    }
    for (const std::string& warning : results.warnings) warnings.push_back(warning);
    return {{"in_short", measurement_in_short(results, warnings.size())},
            {"views", std::move(views)},
            {"machine", machine_facts(results)},
            {"command", results.command},
            {"has_warnings", !warnings.empty()},
            {"warnings", std::move(warnings)},
            {"timings", timing_rows(results)},
            {"metrics", metric_rows()},
            {"levels", visibility_levels_text(source.pictures)},
            {"error_levels", std::to_string(kErrorLevels)},
            {"threshold", short_text(results.mask_threshold)}};
}

}  // namespace aoscore
