#include "experiment/view_run.h"

#include "core/log.h"
#include "core/node_kind.h"
#include "core/progress.h"
#include "experiment/score_goal.h"
#include "jobs/executor.h"
#include "jobs/own_truth.h"
#include "jobs/view_maker.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/roles.h"
#include "plan/run_modes.h"
#include "plan/view_description.h"
#include "screen/method/layer_bytes.h"
#include "screen/method/lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace aoscore {
namespace {

// A radius that differs from the ranking's by this factor says little about a method.
constexpr double kFarRadius = 2;

void add_radius_warnings(const ViewRun& run, std::vector<std::string>& warnings) {
    if (run.radius.automatic) warnings.push_back(radius_warning(run.radius, run.work.view));
    if (!run.drawn_for_m) return;
    for (const ResolvedCell& cell : run.cells) {
        const MethodDescriptor& method = *cell.request.method;
        const auto absolute = method.absolute_presets.find(cell.plan.preset);
        if (absolute == method.absolute_presets.end()) continue;
        const double meant_m = reference_radius(method, cell.plan.preset).value_or(run.radius.metres);
        if (std::abs(std::log(meant_m / run.radius.metres)) <= std::log(kFarRadius)) continue;
        warnings.push_back(
            fmt::format("{}/{} keeps its lengths ({}), meant for a radius of {:g} m; it is ranked "
                        "at {:.4g} m",
                        cell.plan.method, cell.plan.preset, absolute->second, meant_m, run.radius.metres));
    }
}

/// The stored record of the view, under its names in this run.
ViewRecord renamed(ViewRecord stored, const ViewRecord& described) {
    stored.key = described.key;
    stored.scene = described.scene;
    stored.view = described.view;
    stored.view_source = described.view_source;
    stored.view_note = described.view_note;
    stored.radius_rule = described.radius_rule;
    stored.warnings = described.warnings;
    stored.score_error = described.score_error;
    stored.final_answer = described.final_answer;
    stored.lighting = described.lighting;
    stored.lighting_parameters = described.lighting_parameters;
    return stored;
}

CellRecord described_cell(const ViewRun& run, std::size_t i) {
    const ResolvedCell& cell = run.cells[i];
    CellRecord record;
    record.id = run.work.cells[i].id;
    record.view_key = run.work.key;
    record.method = cell.plan.method;
    record.method_label = cell.request.method->shown_label();
    if (cell.request.method->role == MethodRole::bound) record.role = kBoundRole;
    record.preset = cell.plan.preset;
    record.setting = setting_text(cell.plan);
    record.filter = cell.filter;
    const bool visibility_alone = cell.request.signals.empty();
    record.parameters = visibility_alone ? visibility_values(*cell.request.method, cell.request.parameters)
                                         : cell.request.parameters;
    record.lengths = cell.lengths;
    if (const auto bytes = layer_bytes(cell.request, run.work.width, run.work.height))
        record.layer_bytes = static_cast<double>(*bytes);
    for (const auto& [mode, choice] : unusual_modes(cell.plan.modes)) record.parameters[mode] = choice;
    for (const auto& [id, value] : cell.plan.filter_overrides)
        record.parameters[std::string(kFilterPrefix) + id] = value;
    for (const LengthRecord& length : cell.lengths) record.parameters.emplace(length.id, length.value);
    if (!cell.plan.own_truth) return record;
    record.own_truth = cell.own == run.work.queries.front() ? kRankedTruth : truth_id(cell.own);
    return record;
}

// Warns of a small radius in an automatic view; a user who chose the camera knows what it shows.
void warn_of_small_radius(const View& chosen, ViewRecord& view) {
    constexpr double kLeast_px = 15;
    const bool small = view.valid_pixels > 0 && view.radius_px_median < kLeast_px;
    if (!small || chosen.kind != View::Kind::automatic) return;
    view.warnings.push_back(
        fmt::format("the radius is {:.1f} pixels in the median of this automatic view, fewer than {:g}: most "
                    "of what is compared lies at edges; a larger --size, or --eye from nearer by, shows more",
                    view.radius_px_median, kLeast_px));
    log_warning(fmt::format("{}: {}", view.key, view.warnings.back()));
}

// Without intervals every rank is possible, and a reader must know that chance alone has left it so.
void warn_of_few_blocks(const Score* score, ViewRecord& view) {
    if (score == nullptr || !score->analysis) return;
    const std::string why = why_no_intervals(score->analysis->blocks);
    if (why.empty()) return;
    view.warnings.push_back(why + ": every method can have every rank; a larger --size shows more");
    log_warning(fmt::format("{}: {}", view.key, view.warnings.back()));
}

// Pixels whose truth is too uncertain are left out, and they are no sample of all: by the rest, the order of
// methods can be another.
void warn_of_unknown_signals(ViewRecord& view) {
    constexpr double kLeastShare = 0.9;
    for (const SignalRecord& record : view.signals) {
        const double known = static_cast<double>(record.known_pixels),
                     valid = static_cast<double>(view.valid_pixels);
        if (known >= kLeastShare * valid) continue;
        view.warnings.push_back(fmt::format(
            "the truth of {} is certain enough in only {:.1f} % of the pixels, over which methods may "
            "rank otherwise than over all of them; more --samples make it certain",
            record.id, 100 * known / valid));
        log_warning(fmt::format("{}: {}", view.key, view.warnings.back()));
    }
}

// Errors of light are told without the noise of the truth's rays; how sure they are follows from it.
void warn_of_noisy_light(ViewRecord& view) {
    if (!view.light || view.light->standard_error <= IrradianceGoal{}.relative_error * view.light->mean)
        return;
    view.warnings.push_back(fmt::format(
        "the ray-traced irradiance has a standard error of {:.1f} % of its mean after {} rays a "
        "pixel, because {} is bright in small parts: errors of light are less sure than their "
        "intervals say",
        100 * view.light->standard_error / view.light->mean, view.light->samples, view.light->environment));
    log_warning(fmt::format("{}: {}", view.key, view.warnings.back()));
}

void record_times(const StoredTimes& times, const ViewRecord& view, CellRecord& record) {
    record.ao = summarize(times.ao);
    record.filter_pass = summarize(times.filter);
    record.fixed_pass = summarize(times.fixed_pass);
    record.layers_processor = summarize(times.layers_processor_ms);
    record.lighting = summarize(times.lighting);
    record.frame_at_once = summarize(times.frame_at_once);
    record.frame_by_pass = summarize(times.frame_by_pass);
    record.gbuffer = summarize(times.gbuffer);
    record.gbuffer_bytes = times.gbuffer_bytes;
    const std::optional<double> gbuffer_ms =
        record.gbuffer.median_ms ? record.gbuffer.median_ms : view.gbuffer.median_ms;
    if (!record.ao.median_ms || !gbuffer_ms) return;
    const FrameRecord frame = frame_of(*gbuffer_ms, record.lighting.median_ms.value_or(0),
                                       *record.ao.median_ms, record.filter_pass.median_ms.value_or(0));
    record.frame_ms = frame.frame_ms;
    if (record.lighting.median_ms) record.frame = frame;
}

/// The metrics that the truth's noise leaves as certain as the goal asks: methods' own truths have as many
/// rays as the ranking metric needs, which are too few for SSIM.
MetricMap sure_metrics(const OwnScore& own, const std::optional<ScoreGoal>& goal) {
    MetricMap metrics = own.metrics;
    if (!goal) return metrics;
    for (const auto& [id, half_width] : own.truth_noise) {
        if (half_width <= allowed_noise(*goal, id) || !metrics.contains(id)) continue;
        metrics.at(id) = {std::nullopt, fmt::format("the noise of the method's own truth, {} rays a pixel, "
                                                    "leaves it unsure by {:.2g}",
                                                    own.truth.samples, half_width)};
    }
    return metrics;
}

/// Makes a view's results from its artifacts.
class Assembly {
  public:
    Assembly(const ViewRun& run, const ViewMaker& maker, const Execution& done)
        : run_(run), maker_(maker), done_(done) {}

    ViewRecord view(const ViewRecord& described) const {
        ViewRecord view = maker_.view() != nullptr ? renamed(*maker_.view(), described) : described;
        if (maker_.gbuffer_runs() != nullptr) view.gbuffer = summarize(*maker_.gbuffer_runs());
        if (there(run_.jobs.truth_file)) view.truth_file = run_.work.truth_file();
        if (there(run_.jobs.gbuffer_file)) view.gbuffer_file = run_.work.gbuffer_file();
        if (there(run_.jobs.irradiance) && maker_.view_light() != nullptr) {
            view.light = *maker_.view_light();
            view.light->file = run_.work.irradiance_file();
            view.light->environment = run_.work.environment->id();
        }
        for (std::size_t i = 0; i < run_.jobs.cells.size(); ++i) add_own_truth(i, view.truths);
        warn_of_small_radius(run_.work.view, view);
        if (!run_.jobs.cells.empty()) warn_of_few_blocks(maker_.score(run_.jobs.cells.front().score), view);
        warn_of_unknown_signals(view);
        warn_of_noisy_light(view);
        return view;
    }

    double own_noise() const {
        double most = 0;
        for (std::size_t i = 0; i < run_.jobs.cells.size(); ++i) {
            const OwnScore* own = own_score(i);
            if (own != nullptr && own->truth_noise.contains(kRankingMetric))
                most = std::max(most, own->truth_noise.at(kRankingMetric));
        }
        return most;
    }

    CellRecord cell(std::size_t i, const ViewRecord& view) const {
        CellRecord record = described_cell(run_, i);
        const CellKeys& keys = run_.jobs.cells[i];
        record.error = first_error(keys);
        if (run_.work.cells[i].keep_image && there(keys.image)) {
            const Job& drawn = run_.jobs.graph.at(keys.image);
            record.image_file = run_.work.image_file(run_.work.cells[drawn.cell]);
        }
        if (const Score* score = maker_.score(keys.score)) {
            record.nonfinite = score->nonfinite;
            record.ranked = score->ranked;
            record.analysis = score->analysis;
            record.raw = score->raw;
            record.signals = score->signals;
            if (score->reported_ms) {
                record.parameters["reported_ms"] = *score->reported_ms;
                record.parameters["reported_on"] = score->reported_on;
            }
        }
        if (keys.light && maker_.light(*keys.light) != nullptr) record.light = *maker_.light(*keys.light);
        if (there(keys.lit_file)) {
            const Job& lit = run_.jobs.graph.at(*keys.lit_file);
            record.lit_file = run_.work.lit_file(run_.work.cells[lit.cell]);
        }
        if (const OwnScore* own = own_score(i)) record.own = sure_metrics(*own, run_.plan.score_goal);
        if (keys.fetches && maker_.fetches(*keys.fetches) != nullptr)
            record.fetches_per_pixel = *maker_.fetches(*keys.fetches);
        if (keys.repeats && maker_.repeats(*keys.repeats) != nullptr)
            record.repeats = *maker_.repeats(*keys.repeats);
        const StoredTimes* times = keys.times ? maker_.times(*keys.times) : nullptr;
        if (times != nullptr && record.error.empty()) record_times(*times, view, record);
        return record;
    }

  private:
    const OwnScore* own_score(std::size_t i) const {
        const std::optional<Key>& key = run_.jobs.cells[i].own_score;
        return key ? maker_.own_score(*key) : nullptr;
    }

    void add_own_truth(std::size_t i, std::vector<TruthRecord>& truths) const {
        const OwnScore* own = own_score(i);
        if (own == nullptr || run_.work.ranks_by(*run_.work.cells[i].own)) return;
        if (std::ranges::find(truths, own->truth.id, &TruthRecord::id) == truths.end())
            truths.push_back(own->truth);
    }

    bool there(const std::optional<Key>& key) const { return key && !done_.has_failed(*key); }

    /// The reason why the cell failed; empty where it did not.
    std::string first_error(const CellKeys& keys) const {
        for (const std::optional<Key>& key :
             {std::optional(keys.image), std::optional(keys.score), keys.own_score, keys.fetches, keys.times,
              keys.repeats, keys.light, keys.lit_file}) {
            if (key && done_.has_failed(*key)) return done_.failed.at(*key);
        }
        return "";
    }

    const ViewRun& run_;
    const ViewMaker& maker_;
    const Execution& done_;
};

/// Shows the progress of scoring over cells that had no scores.
class ScoreProgress {
  public:
    ScoreProgress(const ViewRun& run, const ArtifactStore& store) : name_("measuring " + run.work.key) {
        std::set<Key> missing;
        for (const CellKeys& keys : run.jobs.cells) {
            if (!store.has(keys.score.hex)) missing.insert(keys.score);
        }
        total_ = missing.size();
    }
    void begin(const Job& job) {
        if (job.kind == ArtifactKind::times) progress_.reset();
        if (job.kind == ArtifactKind::image && !progress_) progress_.emplace(name_, total_);
    }
    void end(const Job& job) {
        if (job.kind == ArtifactKind::score && progress_) progress_->step();
    }

  private:
    std::string name_;
    std::size_t total_ = 0;
    std::optional<Progress> progress_;
};

}  // namespace

ViewRecord described_view(const ViewRun& run) {
    ViewRecord view = describe_view(run.work.scene, run.work.view, run.work.frame(), run.work.key);
    view.lighting = run.lighting;
    view.lighting_parameters = run.lighting_parameters;
    view.radius_m = run.radius.metres;
    view.radius_rule = run.radius.rule;
    if (run.plan.score_goal) {
        view.score_error = run.plan.score_goal->error;
        view.final_answer = run.plan.score_goal->every_metric;
    }
    add_radius_warnings(run, view.warnings);
    return view;
}

ViewOutcome run_view(const ViewRun& run, const ArtifactStore& store) {
    const ViewRecord described = described_view(run);
    ViewMaker maker(run.work, run.jobs, store, described);
    ScoreProgress progress(run, store);
    ExecutionOptions options;
    options.times = takes_times();
    // A sweep has many cells; those of a table are all timed in turns.
    if (run.plan.timing_goal) options.first_group = kFirstGroup;
    options.on_begin = [&](const Job& job) { progress.begin(job); };
    options.on_end = [&](const Job& job) { progress.end(job); };
    const Execution done = execute(run.jobs.graph, maker, options);
    ViewOutcome outcome;
    const Assembly assembly(run, maker, done);
    outcome.view = assembly.view(described);
    if (!done.left_out.empty()) {
        outcome.view.warnings.push_back(times_left_out_text(done.left_out.size()));
        log_warning(run.work.key + ": " + outcome.view.warnings.back());
    }
    for (std::size_t i = 0; i < run.cells.size(); ++i) {
        outcome.cells.push_back(assembly.cell(i, outcome.view));
        const Key& score = run.jobs.cells[i].score;
        outcome.measured += std::ranges::find(done.taken, score) == done.taken.end();
    }
    outcome.rays = maker.rays();
    outcome.own_noise = assembly.own_noise();
    return outcome;
}

}  // namespace aoscore
