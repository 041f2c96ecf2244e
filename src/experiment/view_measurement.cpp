#include "experiment/view_measurement.h"

#include "core/error.h"
#include "experiment/few_rays.h"
#include "experiment/image_output.h"
#include "experiment/masked_mean.h"
#include "experiment/pixel_facts.h"
#include "experiment/timing.h"
#include "experiment/truth_provenance.h"
#include "experiment/truth_record.h"
#include "experiment/view_description.h"
#include "experiment/view_stock.h"
#include "metrics/analysis.h"
#include "metrics/evaluate.h"
#include "reference/cache/truth_cache.h"
#include "results/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aoscore {
namespace {

// What is measured besides the ranking: the perceptual metrics cost more than all others together.
const std::vector<std::string> kUnrankedMetrics{"rmse", "rmse_debiased", "mae", "bias", "ssim"};

}  // namespace

std::string file_name(std::string id) {
    std::replace(id.begin(), id.end(), '/', '-');
    return id;
}

void ViewMeasurement::draw() {
    if (drawn_) return;
    drawn_ = true;
    std::set<std::string> inputs = run_.read_inputs();
    ScreenRenderer& renderer = run_.tools.ready_renderer();
    const double first_ms = renderer.draw_gbuffer(frame_, inputs);
    if (run_.times_gbuffer() && !view_.gbuffer.median_ms) {
        std::vector<double> runs_ms;
        for (int i = timed_runs(first_ms); i > 0; --i) runs_ms.push_back(renderer.time_gbuffer());
        view_.gbuffer = summarize(std::move(runs_ms));
    }
    // What no cell reads is no cost of theirs: it comes after the clock.
    const std::size_t timed_inputs = inputs.size();
    if (run_.pictured()) inputs.insert(run_.kept_inputs.begin(), run_.kept_inputs.end());
    if (inputs.size() > timed_inputs) renderer.draw_gbuffer(frame_, inputs);
    gbuffer_ = renderer.read_gbuffer();
}

void ViewMeasurement::trace() {
    if (traced_) return;
    traced_ = true;
    draw();
    obtain_truth();
    facts_ = pixel_facts(frame_, truth_);
    view_.truths.clear();  // what the store had of them
    view_.causes.clear();
    check_contract();
    record_truth(truth_, contract_.valid, view_);
}

// All truths of the view come from the same rays: the ranking's first, then every method's own.
void ViewMeasurement::obtain_truth() {
    const ReferenceScene& reference = run_.tools.reference();
    const TruthRequest request{run_.scene.digest,
                               run_.view.camera,
                               run_.plan.width,
                               run_.plan.height,
                               wanted_queries(run_, view_.radius_m),
                               truth_settings(run_),
                               reference.build()};
    const TruthLabel label{scene_name(run_.scene), run_.view.id, run_.command};
    CachedTruth traced = trace_truth(run_.truth_cache, reference, request, label, "truth " + run_.key);
    header_ = truth_provenance(run_.scene, traced, run_.command);
    header_["aoscore:view"] = run_.key;
    truth_ = std::move(traced.truth);
    rays_ = traced.origin == TruthOrigin::cached ? 0 : truth_.rays;
    view_.truth_origin = origin_id(traced.origin);
    view_.least_samples = traced.made_for.settings.samples;
    view_.integrator = kIntegratorVersion;
    TruthRequest again = traced.made_for;
    again.queries = request.queries;
    std::erase_if(again.queries, [](const TruthQuery& query) { return query.falloff != Falloff::binary; });
    view_.truth_command = reference_command(run_.scene, run_.view, again, file_name(run_.key) + "-truth.exr");
    if (traced.made_for.settings.max_error > 0) view_.max_error = traced.made_for.settings.max_error;
}

void ViewMeasurement::check_contract() {
    const Bounds& bounds = run_.scene.bounds;
    const double extent = glm::max(glm::length(bounds.low), glm::length(bounds.high));
    contract_ = check_camera_contract(frame_, truth_.hits, gbuffer_, extent);
    ViewRecord& v = view_;
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

void ViewMeasurement::write_images() {
    trace();
    ViewRecord& v = view_;
    const std::string stem = "views/" + file_name(run_.key);
    v.truth_file = stem + "-truth.exr";
    write_truth(run_.folder / v.truth_file, truth_, contract_.valid, header_);
    if (run_.keep_gbuffer) {
        v.gbuffer_file = stem + "-gbuffer.exr";
        write_gbuffer(run_.folder / v.gbuffer_file, gbuffer_, {}, {{"aoscore:view", v.key}});
    }
}

MetricMap ViewMeasurement::metrics_against(const TruthQuery& query, const ImageF& test, const Mask& valid,
                                           std::span<const std::string> ids) const {
    const auto q = static_cast<std::size_t>(std::find(truth_.queries.begin(), truth_.queries.end(), query) -
                                            truth_.queries.begin());
    const MetricInput input{truth_.visibility[q], test, valid, &truth_.standard_error[q]};
    return evaluate(input, ids);
}

MethodOutput ViewMeasurement::output_of(const MethodRequest& request) {
    ScreenRenderer& renderer = run_.tools.ready_renderer();
    if (!is_few_rays(request)) return renderer.run(request);
    MethodOutput output;
    output.raw = trace_few_rays(run_.tools.reference(), frame_, request);
    output.visibility = renderer.filter(output.raw, request);
    return output;
}

void ViewMeasurement::measure(const ResolvedCell& cell, CellRecord& record) {
    trace();
    if (view_.valid_pixels == 0 && contract_.kept()) throw Error(ExitCode::gate_failed, emptiness(view_));
    const bool filtered = cell.request.filter != nullptr;
    const MethodOutput output = output_of(cell.request);

    if (cell.plan.keep_image) {
        std::vector<ChannelView> channels{{"Y", &output.visibility}};
        if (filtered) channels.push_back({"raw.Y", &output.raw});
        record.image_file = "cells/" + file_name(record.id) + ".exr";
        write_exr(run_.folder / record.image_file, channels, {{"aoscore:cell", record.id}});
    }

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
    MapSums maps;
    const MetricInput ranked{truth_.visibility[0], output.visibility, valid, &truth_.standard_error[0],
                             &maps};
    record.ranked = evaluate(ranked);
    record.analysis = analyse(ranked, facts_, run_.mask_threshold, run_.seed);
    if (cell.plan.own_truth)
        record.own = metrics_against(cell.own, output.visibility, valid, kUnrankedMetrics);
    if (filtered) {
        std::size_t nonfinite = 0;
        const Mask raw_valid = finite_pixels(truth_.visibility[0], output.raw, contract_.valid, nonfinite);
        record.raw = metrics_against(truth_.queries[0], output.raw, raw_valid, kUnrankedMetrics);
    }
    record.fetches_per_pixel =
        mean_over(run_.tools.ready_renderer().count_fetches(cell.request), contract_.valid);
}

}  // namespace aoscore
