#include "experiment/view_run.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "experiment/camera_contract.h"
#include "experiment/cell_timing.h"
#include "experiment/experiment.h"
#include "experiment/image_output.h"
#include "experiment/masked_mean.h"
#include "experiment/own_truth.h"
#include "experiment/pixel_facts.h"
#include "experiment/run_modes.h"
#include "experiment/timing.h"
#include "experiment/truth_provenance.h"
#include "experiment/truth_record.h"
#include "experiment/view_description.h"
#include "metrics/analysis.h"
#include "metrics/evaluate.h"
#include "metrics/metric.h"
#include "reference/cache/truth_cache.h"
#include "results/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace aoscore {
namespace {

// What is measured besides the ranking: the perceptual metrics cost more than all others together.
const std::vector<std::string> kUnrankedMetrics{"rmse", "rmse_debiased", "mae", "bias", "ssim"};

std::string file_name(std::string id) {
    std::replace(id.begin(), id.end(), '/', '-');
    return id;
}

class Runner {
  public:
    explicit Runner(const ViewRun& run)
        : run_(run), frame_(run.view.camera, run.plan.width, run.plan.height) {}

    ViewOutcome measure() {
        outcome_.view = describe_view(run_.scene, run_.view, frame_, run_.key);
        outcome_.view.radius_m =
            ranking_radius(run_.plan.radius_m, run_.view, run_.scene, outcome_.view.warnings);
        obtain_truth();
        facts_ = pixel_facts(frame_, truth_);
        draw_gbuffer();
        check_contract();
        record_truth(truth_, contract_.valid, outcome_.view);
        write_images();
        for (std::size_t i = 0; i < run_.cells.size(); ++i) {
            throw_if_interrupted();
            outcome_.cells.push_back(describe_cell(run_.cells[i]));
            run_guarded(i, [&] { measure_cell(i); });
        }
        record_times();
        return std::move(outcome_);
    }

  private:
    // All truths of the view come from the same rays: the ranking's first, then every method's own.
    void obtain_truth() {
        std::vector<TruthQuery> queries{{Falloff::binary, outcome_.view.radius_m, 0}};
        for (const ResolvedCell& cell : run_.cells) {
            if (std::find(queries.begin(), queries.end(), cell.own) == queries.end())
                queries.push_back(cell.own);
        }
        TruthSettings settings;
        settings.samples = run_.plan.samples;
        settings.max_error = run_.plan.max_error;
        settings.seed = run_.seed;
        settings.extras = run_.plan.extras;
        const TruthRequest request{run_.scene.digest,     run_.view.camera,   run_.plan.width,
                                   run_.plan.height,      std::move(queries), settings,
                                   run_.reference.build()};
        const TruthLabel label{scene_name(run_.scene), run_.view.id, run_.command};
        CachedTruth traced =
            trace_truth(run_.truth_cache, run_.reference, request, label, "truth " + run_.key);
        header_ = truth_provenance(run_.scene, traced, run_.command);
        header_["aoscore:view"] = run_.key;
        truth_ = std::move(traced.truth);
        ViewRecord& view = outcome_.view;
        view.truth_origin = origin_id(traced.origin);
        if (traced.made_for.settings.max_error > 0) view.max_error = traced.made_for.settings.max_error;
    }

    void draw_gbuffer() {
        std::set<std::string> inputs;
        for (const ResolvedCell& cell : run_.cells) inputs.merge(needed_gbuffer_inputs(cell.request));
        const int runs = timed_runs(run_.renderer.draw_gbuffer(frame_, inputs));
        std::vector<double> runs_ms;
        for (int i = 0; i < runs; ++i) runs_ms.push_back(run_.renderer.draw_gbuffer(frame_, inputs));
        outcome_.view.gbuffer = summarize(std::move(runs_ms));
        // What no cell reads is no cost of theirs: it comes after the clock.
        const std::size_t timed_inputs = inputs.size();
        inputs.insert(run_.kept_inputs.begin(), run_.kept_inputs.end());
        if (inputs.size() > timed_inputs) run_.renderer.draw_gbuffer(frame_, inputs);
        gbuffer_ = run_.renderer.read_gbuffer();
    }

    void check_contract() {
        const Bounds& bounds = run_.scene.bounds;
        const double extent = glm::max(glm::length(bounds.low), glm::length(bounds.high));
        contract_ = check_camera_contract(frame_, truth_.hits, gbuffer_, extent);
        ViewRecord& v = outcome_.view;
        v.surface_pixels = contract_.surface;
        v.valid_pixels = contract_.valid_count;
        v.disagreeing_pixels = contract_.disagreeing;
        v.edge_pixels = contract_.edges;
        std::vector<float> depths;
        for (std::size_t i = 0; i < truth_.hits.depth.size(); ++i) {
            if (contract_.valid.pixels[i] != 0) depths.push_back(truth_.hits.depth.pixels[i]);
        }
        if (!depths.empty()) {
            const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
            std::nth_element(depths.begin(), middle, depths.end());
            v.radius_px_median = v.radius_m * frame_.pixels_per_metre(static_cast<double>(*middle));
        }
    }

    void write_images();

    CellRecord describe_cell(const ResolvedCell& cell) const {
        CellRecord record;
        record.id = fmt::format("{}/{}/{}", run_.key, cell.plan.method, cell.plan.preset);
        if (cell.plan.filter) record.id += "/" + cell.filter;
        record.view_key = run_.key;
        record.method = cell.plan.method;
        record.method_label = cell.request.method->label;
        record.preset = cell.plan.preset;
        record.filter = cell.filter;
        record.parameters = cell.request.parameters;
        for (const auto& [mode, choice] : unusual_modes(cell.plan.modes)) record.parameters[mode] = choice;
        const auto& queries = truth_.queries;
        const auto own = std::find(queries.begin(), queries.end(), cell.own);
        record.own_truth = outcome_.view.truths[static_cast<std::size_t>(own - queries.begin())].id;
        return record;
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

    MetricMap metrics_against(const TruthQuery& query, const ImageF& test, const Mask& valid,
                              std::span<const std::string> ids = {}) const {
        const auto q = static_cast<std::size_t>(
            std::find(truth_.queries.begin(), truth_.queries.end(), query) - truth_.queries.begin());
        const MetricInput input{truth_.visibility[q], test, valid, &truth_.standard_error[q]};
        return evaluate(input, ids);
    }

    void measure_cell(std::size_t i) {
        const ResolvedCell& cell = run_.cells[i];
        CellRecord& record = outcome_.cells[i];
        const bool filtered = cell.request.filter != nullptr;
        const MethodOutput output = run_.renderer.run(cell.request);

        std::vector<ChannelView> channels{{"Y", &output.visibility}};
        if (filtered) channels.push_back({"raw.Y", &output.raw});
        record.image_file = "cells/" + file_name(record.id) + ".exr";
        write_exr(run_.folder / record.image_file, channels, {{"aoscore:cell", record.id}});

        if (!contract_.kept()) {
            throw internal_error(
                fmt::format("ray tracer and rasteriser disagree on {:.2f} % of the pixels away from "
                            "edges, more than {:.1f} %",
                            100 * contract_.disagreeing_share(), 100 * CameraContract::kTolerated));
        }
        const Mask valid =
            finite_pixels(truth_.visibility[0], output.visibility, contract_.valid, record.nonfinite);
        if (record.nonfinite > 0) {
            throw internal_error(fmt::format("{} pixels are NaN or infinite", record.nonfinite));
        }
        record.ranked = metrics_against(truth_.queries[0], output.visibility, valid);
        record.analysis = analyse({truth_.visibility[0], output.visibility, valid, &truth_.standard_error[0]},
                                  facts_, run_.mask_threshold, run_.seed);
        record.own = metrics_against(cell.own, output.visibility, valid, kUnrankedMetrics);
        if (filtered) {
            std::size_t nonfinite = 0;
            const Mask raw_valid =
                finite_pixels(truth_.visibility[0], output.raw, contract_.valid, nonfinite);
            record.raw = metrics_against(truth_.queries[0], output.raw, raw_valid, kUnrankedMetrics);
        }
        record.fetches_per_pixel = mean_over(run_.renderer.count_fetches(cell.request), contract_.valid);
    }

    void record_times() {
        std::vector<bool> wanted;
        for (const CellRecord& record : outcome_.cells) wanted.push_back(record.error.empty());
        const std::vector<CellTimes> times =
            time_cells(run_.renderer, run_.cells, wanted, "timing " + run_.key);
        const std::optional<double> gbuffer_ms = outcome_.view.gbuffer.median_ms;
        for (std::size_t i = 0; i < times.size(); ++i) {
            CellRecord& record = outcome_.cells[i];
            if (record.error.empty()) record.error = times[i].error;
            record.ao = summarize(times[i].ao_ms);
            record.blur = summarize(times[i].filter_ms);
            if (record.ao.median_ms && gbuffer_ms) {
                record.frame_ms = *gbuffer_ms + *record.ao.median_ms + record.blur.median_ms.value_or(0);
            }
        }
    }

    const ViewRun& run_;
    CameraFrame frame_;
    ViewOutcome outcome_;
    Truth truth_;
    std::map<std::string, std::string> header_;  // of the truth file
    GBufferImages gbuffer_;
    CameraContract contract_;
    PixelFacts facts_;
};

void Runner::write_images() {
    ViewRecord& v = outcome_.view;
    const std::string stem = "views/" + file_name(run_.key);
    v.truth_file = stem + "-truth.exr";
    write_truth(run_.folder / v.truth_file, truth_, contract_.valid, header_);
    if (run_.keep_gbuffer) {
        v.gbuffer_file = stem + "-gbuffer.exr";
        write_gbuffer(run_.folder / v.gbuffer_file, gbuffer_, {}, {{"aoscore:view", v.key}});
    }
}

}  // namespace

ViewOutcome run_view(const ViewRun& run) {
    return Runner(run).measure();
}

}  // namespace aoscore
