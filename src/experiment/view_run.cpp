#include "experiment/view_run.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/log.h"
#include "core/progress.h"
#include "core/stopwatch.h"
#include "experiment/cell_timing.h"
#include "experiment/few_rays.h"
#include "experiment/own_truth.h"
#include "experiment/run_modes.h"
#include "experiment/timing.h"
#include "experiment/view_description.h"
#include "experiment/view_measurement.h"
#include "experiment/view_stock.h"
#include "reference/cache/truth_cache.h"
#include "screen/lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace aoscore {
namespace {

// A radius that lies so far from the ranking's, either way, says little of a method.
constexpr double kFarRadius = 2;

void add_radius_warnings(const ViewRun& run, std::vector<std::string>& warnings) {
    if (run.radius.automatic) warnings.push_back(radius_warning(run.radius, run.view));
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

class Runner {
  public:
    Runner(const ViewRun& run, const MeasurementStore& store, const ViewStock& stock)
        : run_(run),
          store_(store),
          stock_(stock),
          frame_(run.view.camera, run.plan.width, run.plan.height),
          measurement_(run_, frame_, outcome_.view) {}

    ViewOutcome measure() {
        describe_view_and_cells();
        const bool view_reused = reuse_view();
        std::vector<bool> measured_before, timed_before;
        for (std::size_t i = 0; i < run_.cells.size(); ++i) {
            measured_before.push_back(reuse_cell(i));
            timed_before.push_back(stock_.times[i].has_value());
        }
        if (!view_reused) make_view();
        measure_cells(measured_before);
        record_times(timed_before);
        warn_of_small_radius();
        outcome_.rays = measurement_.rays();
        return std::move(outcome_);
    }

  private:
    void describe_view_and_cells() {
        outcome_.view = describe_view(run_.scene, run_.view, frame_, run_.key);
        if (run_.plan.lit) {
            outcome_.view.lighting = run_.lighting.label;
            outcome_.view.lighting_parameters = drawn_values(run_.lighting, "default", {}, run_.drawn_for_m);
        }
        outcome_.view.radius_m = run_.radius.metres;
        outcome_.view.radius_rule = run_.radius.rule;
        add_radius_warnings(run_, outcome_.view.warnings);
        for (const ResolvedCell& cell : run_.cells) outcome_.cells.push_back(describe_cell(cell));
    }

    // Who chose the camera himself knows what it shows.
    void warn_of_small_radius() {
        constexpr double kLeast_px = 15;
        ViewRecord& view = outcome_.view;
        const bool small = view.valid_pixels > 0 && view.radius_px_median < kLeast_px;
        if (!small || run_.view.kind != View::Kind::automatic) return;
        view.warnings.push_back(fmt::format(
            "the radius is {:.1f} pixels in the median of this automatic view, fewer than {:g}: most "
            "of what is compared lies at edges; a larger --size, or --eye from nearer by, shows more",
            view.radius_px_median, kLeast_px));
        log_warning(fmt::format("{}: {}", view.key, view.warnings.back()));
    }

    CellRecord describe_cell(const ResolvedCell& cell) const {
        CellRecord record;
        record.id = fmt::format("{}/{}", run_.key, cell_name(cell.plan));
        record.view_key = run_.key;
        record.method = cell.plan.method;
        record.method_label = cell.request.method->shown_label();
        if (cell.request.method->role == MethodRole::bound) record.role = kBoundRole;
        record.preset = cell.plan.preset;
        record.setting = setting_text(cell.plan);
        record.filter = cell.filter;
        record.parameters = cell.request.parameters;
        record.lengths = cell.lengths;
        for (const auto& [mode, choice] : unusual_modes(cell.plan.modes)) record.parameters[mode] = choice;
        for (const auto& [id, value] : cell.plan.filter_overrides)
            record.parameters[std::string(kFilterPrefix) + id] = value;
        for (const LengthRecord& length : cell.lengths) record.parameters.emplace(length.id, length.value);
        if (!cell.plan.own_truth) return record;
        const bool ranked = cell.own == TruthQuery{Falloff::binary, outcome_.view.radius_m, 0};
        record.own_truth = ranked ? "ranked" : truth_id(cell.own);
        return record;
    }

    // What the store has of the view, under its name in this run.
    bool reuse_view() {
        if (!stock_.view) return false;
        ViewRecord stored = *stock_.view;
        const ViewRecord& described = outcome_.view;
        stored.key = described.key;
        stored.scene = described.scene;
        stored.view = described.view;
        stored.view_source = described.view_source;
        stored.view_note = described.view_note;
        stored.radius_rule = described.radius_rule;
        stored.warnings = described.warnings;
        stored.lighting = described.lighting;
        stored.lighting_parameters = described.lighting_parameters;
        stored.truth_origin = origin_id(TruthOrigin::cached);
        stored.truth_rays_now = 0;
        stored.savings.left_out_triangles = 0;
        if (run_.pictured()) {
            stored.truth_file = view_file("truth");
            if (!store_.fetch_file(stock_.truth_file_key, run_.folder / stored.truth_file)) return false;
            if (run_.keep_gbuffer) {
                stored.gbuffer_file = view_file("gbuffer");
                if (!store_.fetch_file(stock_.gbuffer_file_key, run_.folder / stored.gbuffer_file))
                    return false;
            }
        }
        if (run_.times_gbuffer() && !stored.gbuffer.median_ms) return false;
        outcome_.view = std::move(stored);
        return true;
    }

    std::string view_file(const std::string& what) const {
        return fmt::format("views/{}-{}.exr", file_name(run_.key), what);
    }

    void make_view() {
        measurement_.trace();
        if (run_.pictured()) {
            measurement_.write_images();
            store_.put_file(stock_.truth_file_key, run_.folder / outcome_.view.truth_file);
            if (run_.keep_gbuffer)
                store_.put_file(stock_.gbuffer_file_key, run_.folder / outcome_.view.gbuffer_file);
        }
        ViewRecord stored = outcome_.view;
        stored.truth_file.clear();
        stored.gbuffer_file.clear();
        store_.put(stock_.view_key, to_json(stored));
    }

    bool reuse_cell(std::size_t i) {
        if (!stock_.cells[i]) return false;
        const CellRecord& stored = *stock_.cells[i];
        CellRecord& record = outcome_.cells[i];
        if (run_.cells[i].plan.keep_image) {
            const std::string file = image_file(record);
            if (!store_.fetch_file(stock_.image_keys[i], run_.folder / file)) return false;
            record.image_file = file;
        }
        record.ranked = stored.ranked;
        record.own = stored.own;
        record.raw = stored.raw;
        record.analysis = stored.analysis;
        record.fetches_per_pixel = stored.fetches_per_pixel;
        record.nonfinite = stored.nonfinite;
        return true;
    }

    // A cell that fails becomes a failed row; only an interrupt ends the whole run.
    template <class Action>
    void run_guarded(std::size_t i, Action action) {
        CellRecord& record = outcome_.cells[i];
        if (!record.error.empty()) return;
        try {
            action();
        } catch (const Error& e) {
            if (e.exit_code() == ExitCode::interrupted) throw;
            record.error = e.what();
        }
    }

    void measure_cells(const std::vector<bool>& measured_before) {
        const auto missing = std::ranges::count(measured_before, false);
        if (missing == 0) return;
        measurement_.trace();  // it has a progress of its own
        Progress progress("measuring " + run_.key, static_cast<std::size_t>(missing));
        for (std::size_t i = 0; i < run_.cells.size(); ++i) {
            if (measured_before[i]) continue;
            throw_if_interrupted();
            ++outcome_.measured;
            run_guarded(i, [&] { measure_cell(i); });
            progress.step();
        }
    }

    void measure_cell(std::size_t i) {
        CellRecord& record = outcome_.cells[i];
        measurement_.measure(run_.cells[i], record);
        if (!record.image_file.empty())
            store_.put_file(stock_.image_keys[i], run_.folder / record.image_file);
        store_.put(stock_.cell_keys[i], to_json(record));
    }

    void record_times(const std::vector<bool>& timed_before) {
        std::vector<std::size_t> wanted;
        for (std::size_t i = 0; i < run_.cells.size(); ++i) {
            if (!outcome_.cells[i].error.empty()) continue;
            if (timed_before[i])
                record_cell_times(i, *stock_.times[i]);
            else
                wanted.push_back(i);
        }
        // A sweep has many cells; those of a table are all timed in turns.
        std::size_t together = run_.plan.timing_goal ? kFirstGroup : wanted.size();
        for (std::span<const std::size_t> rest = wanted; !rest.empty();) {
            const auto group = rest.first(std::min(together, rest.size()));
            const Stopwatch watch;
            time_group(group);
            together = next_group(together, watch.seconds());
            rest = rest.subspan(group.size());
        }
    }

    // The fixed pass is timed among them.
    void time_group(std::span<const std::size_t> group) {
        measurement_.draw();
        std::vector<ResolvedCell> cells;
        std::vector<bool> timed;
        for (const std::size_t i : group) {
            cells.push_back(run_.cells[i]);
            timed.push_back(!is_few_rays(cells.back().request));
            if (cells.back().plan.whole_frames) light(cells.back().request, run_.lighting, run_.drawn_for_m);
        }
        cells.emplace_back().request = run_.fixed_pass_request();
        timed.push_back(true);
        const std::vector<CellTimes> times = time_cells(run_.tools.ready_renderer(), cells, timed,
                                                        run_.plan.timing_goal, "timing " + run_.key);
        const CellTimes& fixed_pass = times.back();
        const double fixed_pass_ms = summarize(fixed_pass.ao_ms).median_ms.value_or(0);
        for (std::size_t k = 0; k < group.size(); ++k) {
            CellRecord& record = outcome_.cells[group[k]];
            record.error = times[k].error;
            if (!record.error.empty()) continue;
            const StoredTimes stored{
                times[k].ao_ms,         times[k].filter_ms,        fixed_pass_ms,
                fixed_pass.lighting_ms, times[k].frame_at_once_ms, times[k].frame_by_pass_ms};
            record_cell_times(group[k], stored);
            store_.put(stock_.time_keys[group[k]], to_json(stored));
        }
    }

    void record_cell_times(std::size_t i, const StoredTimes& times) {
        CellRecord& record = outcome_.cells[i];
        record.ao = summarize(times.ao_ms);
        record.blur = summarize(times.filter_ms);
        if (times.fixed_pass_ms > 0) record.fixed_pass_ms = times.fixed_pass_ms;
        record.lighting = summarize(times.lighting_ms);
        record.frame_at_once = summarize(times.frame_at_once_ms);
        record.frame_by_pass = summarize(times.frame_by_pass_ms);
        const std::optional<double> gbuffer_ms = outcome_.view.gbuffer.median_ms;
        if (!record.ao.median_ms || !gbuffer_ms) return;
        const FrameRecord frame = frame_of(*gbuffer_ms, record.lighting.median_ms.value_or(0),
                                           *record.ao.median_ms, record.blur.median_ms.value_or(0));
        record.frame_ms = frame.frame_ms;
        if (record.lighting.median_ms) record.frame = frame;
    }

    static std::string image_file(const CellRecord& record) {
        return "cells/" + file_name(record.id) + ".exr";
    }

    const ViewRun& run_;
    const MeasurementStore& store_;
    const ViewStock& stock_;
    CameraFrame frame_;
    ViewOutcome outcome_;
    ViewMeasurement measurement_;
};

}  // namespace

bool ViewRun::pictured() const {
    return std::any_of(cells.begin(), cells.end(),
                       [](const ResolvedCell& cell) { return cell.plan.keep_image; });
}

bool ViewRun::times_gbuffer() const {
    return pictured() || plan.timing_goal.has_value();
}

std::set<std::string> ViewRun::read_inputs() const {
    std::set<std::string> inputs;
    for (const ResolvedCell& cell : cells) inputs.merge(needed_gbuffer_inputs(cell.request));
    inputs.merge(needed_gbuffer_inputs(fixed_pass_request()));
    return inputs;
}

MethodRequest ViewRun::fixed_pass_request() const {
    MethodRequest request;
    request.method = &fixed_pass;
    request.parameters = fixed_pass.values("default");
    request.seed = seed;
    if (plan.lit) light(request, lighting, drawn_for_m);
    return request;
}

ViewOutcome run_view(const ViewRun& run, const MeasurementStore& store, const ViewStock& stock) {
    return Runner(run, store, stock).measure();
}

}  // namespace aoscore
