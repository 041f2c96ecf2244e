#pragma once

#include "results/analysis_members.h"
#include "results/results.h"

/// The members of every record of results.json, by key: the one list for both writing and reading, so that
/// neither can forget a member. `visit(key, member)` is called for each; `Record` may be const.
namespace aoscore {

template <class Visit, RecordOf<MeasuredMetric> Record>
void visit_members(Visit& visit, Record& metric) {
    visit("value", metric.value);
    visit("note", metric.note);
}

template <class Visit, RecordOf<Timing> Record>
void visit_members(Visit& visit, Record& timing) {
    visit("runs_ms", timing.runs_ms);
    visit("median_ms", timing.median_ms);
    visit("spread_ms", timing.spread_ms);
    visit("processor_runs_ms", timing.processor_runs_ms);
}

template <class Visit, RecordOf<FoundOcclusion> Record>
void visit_members(Visit& visit, Record& found) {
    visit("strength", found.strength);
    visit("hidden", found.hidden);
    visit("found", found.found);
    visit("found_fitted", found.found_fitted);
    visit("visible", found.visible);
    visit("kept", found.kept);
    visit("pixels", found.pixels);
    visit("finders", found.finders);
    visit("parts", found.parts);
    visit("squared_parts", found.squared_parts);
}

template <class Visit, RecordOf<Convergence> Record>
void visit_members(Visit& visit, Record& convergence) {
    visit("counts", convergence.counts);
    visit("squares", convergence.squares);
    visit("bands", convergence.bands);
}

template <class Visit, RecordOf<AngleBlocks> Record>
void visit_members(Visit& visit, Record& angles) {
    visit("counts", angles.counts);
    visit("absolute_sums", angles.absolute_sums);
    visit("signed_sums", angles.signed_sums);
}

template <class Visit, RecordOf<Repeats> Record>
void visit_members(Visit& visit, Record& repeats) {
    visit("counts", repeats.counts);
    visit("variance", repeats.variance);
    visit("raw_variance", repeats.raw_variance);
    visit("of_truth", repeats.of_truth);
    visit("of_layers", repeats.of_layers);
    visit("of_grazing", repeats.of_grazing);
    visit("raw_from_converged", repeats.raw_from_converged);
    visit("from_converged", repeats.from_converged);
    visit("hidden_signals", repeats.hidden_signals);
    visit("other_signals", repeats.other_signals);
    visit("hidden_angles", repeats.hidden_angles);
    visit("other_angles", repeats.other_angles);
}

template <class Visit, RecordOf<TruthRecord> Record>
void visit_members(Visit& visit, Record& truth) {
    visit("id", truth.id);
    visit("falloff", truth.falloff);
    visit("radius_m", truth.radius_m);
    visit("u_m", truth.u_m);
    visit("channel", truth.channel);
    visit("se_channel", truth.se_channel);
    visit("mean_standard_error", truth.mean_standard_error);
    visit("noise_floor_rmse", truth.noise_floor_rmse);
    visit("samples", truth.samples);
}

template <class Visit, RecordOf<CauseRecord> Record>
void visit_members(Visit& visit, Record& cause) {
    visit("id", cause.id);
    visit("channel", cause.channel);
    visit("mean_occlusion", cause.mean_occlusion);
}

template <class Visit, RecordOf<SignalRecord> Record>
void visit_members(Visit& visit, Record& signal) {
    visit("id", signal.id);
    visit("mean_standard_error_deg", signal.mean_standard_error_deg);
    visit("known_pixels", signal.known_pixels);
}

template <class Visit, RecordOf<MeasureRecord> Record>
void visit_members(Visit& visit, Record& record) {
    visit("value", record.value);
    visit("interval", record.interval);
}

template <class Visit, RecordOf<LightRecord> Record>
void visit_members(Visit& visit, Record& light) {
    visit("environment", light.environment);
    visit("file", light.file);
    visit("mean", light.mean);
    visit("standard_error", light.standard_error);
    visit("samples", light.samples);
    visit("of_truth", light.of_truth);
}

template <class Visit, RecordOf<TruthSavings> Record>
void visit_members(Visit& visit, Record& savings) {
    visit("most_samples", savings.most_samples);
    visit("background_rays", savings.background_rays);
    visit("open_rays", savings.open_rays);
    visit("converged_rays", savings.converged_rays);
    visit("tiles", savings.tiles);
    visit("untraced_tiles", savings.untraced_tiles);
    visit("left_out_triangles", savings.left_out_triangles);
}

template <class Visit, RecordOf<ViewRecord> Record>
void visit_members(Visit& visit, Record& view) {
    visit("key", view.key);
    visit("scene", view.scene);
    visit("view", view.view);
    visit("scene_digest", view.scene_digest);
    visit("view_source", view.view_source);
    visit("view_note", view.view_note);
    visit("triangles", view.triangles);
    visit("width", view.width);
    visit("height", view.height);
    visit("position_m", view.position_m);
    visit("target_m", view.target_m);
    visit("up", view.up);
    visit("projection", view.projection);
    visit("fovy_deg", view.fovy_deg);
    visit("half_height_m", view.half_height_m);
    visit("near_m", view.near_m);
    visit("far_m", view.far_m);
    visit("radius_m", view.radius_m);
    visit("radius_rule", view.radius_rule);
    visit("radius_px_median", view.radius_px_median);
    visit("surface_pixels", view.surface_pixels);
    visit("valid_pixels", view.valid_pixels);
    visit("disagreeing_pixels", view.disagreeing_pixels);
    visit("edge_pixels", view.edge_pixels);
    visit("truth_file", view.truth_file);
    visit("gbuffer_file", view.gbuffer_file);
    visit("truths", view.truths);
    visit("causes", view.causes);
    visit("signals", view.signals);
    visit("light", view.light);
    visit("one_layer_channel", view.one_layer_channel);
    visit("samples", view.samples);
    visit("max_error", view.max_error);
    visit("halves", view.halves);
    visit("score_error", view.score_error);
    visit("final_answer", view.final_answer);
    visit("open_pixels", view.open_pixels);
    visit("truth_seconds", view.truth_seconds);
    visit("truth_origin", view.truth_origin);
    visit("least_samples", view.least_samples);
    visit("integrator", view.integrator);
    visit("truth_command", view.truth_command);
    visit("truth_rays_now", view.truth_rays_now);
    visit("truth_rays", view.truth_rays);
    visit("background_pixels", view.background_pixels);
    visit("savings", view.savings);
    visit("gbuffer", view.gbuffer);
    visit("lighting", view.lighting);
    visit("lighting_parameters", view.lighting_parameters);
    visit("warnings", view.warnings);
}

template <class Visit, RecordOf<FrameRecord> Record>
void visit_members(Visit& visit, Record& frame) {
    visit("geometry_ms", frame.geometry_ms);
    visit("lighting_ms", frame.lighting_ms);
    visit("geometry_lighting_ms", frame.geometry_lighting_ms);
    visit("ao_ms", frame.ao_ms);
    visit("filter_ms", frame.filter_ms);
    visit("frame_ms", frame.frame_ms);
    visit("geometry_lighting_share", frame.geometry_lighting_share);
    visit("ao_share", frame.ao_share);
    visit("filter_share", frame.filter_share);
    visit("per_second", frame.per_second);
    visit("per_second_without_ao", frame.per_second_without_ao);
    visit("per_second_unfiltered", frame.per_second_unfiltered);
}

template <class Visit, RecordOf<LengthRecord> Record>
void visit_members(Visit& visit, Record& length) {
    visit("id", length.id);
    visit("value", length.value);
    visit("unit", length.unit);
    visit("origin", length.origin);
}

template <class Visit, RecordOf<CellRecord> Record>
void visit_members(Visit& visit, Record& cell) {
    visit("id", cell.id);
    visit("view_key", cell.view_key);
    visit("method", cell.method);
    visit("method_label", cell.method_label);
    visit("role", cell.role);
    visit("preset", cell.preset);
    visit("setting", cell.setting);
    visit("filter", cell.filter);
    visit("parameters", cell.parameters);
    visit("lengths", cell.lengths);
    visit("error", cell.error);
    visit("ao", cell.ao);
    visit("filter_pass", cell.filter_pass);
    visit("layers_processor", cell.layers_processor);
    visit("fixed_pass", cell.fixed_pass);
    visit("lighting", cell.lighting);
    visit("gbuffer", cell.gbuffer);
    visit("gbuffer_bytes", cell.gbuffer_bytes);
    visit("layer_bytes", cell.layer_bytes);
    visit("frame_ms", cell.frame_ms);
    visit("frame", cell.frame);
    visit("frame_at_once", cell.frame_at_once);
    visit("frame_by_pass", cell.frame_by_pass);
    visit("fetches_per_pixel", cell.fetches_per_pixel);
    visit("nonfinite", cell.nonfinite);
    visit("ranked_truth", cell.ranked_truth);
    visit("own_truth", cell.own_truth);
    visit("ranked", cell.ranked);
    visit("own", cell.own);
    visit("raw", cell.raw);
    visit("signals", cell.signals);
    visit("analysis", cell.analysis);
    visit("repeats", cell.repeats);
    visit("light", cell.light);
    visit("lit_file", cell.lit_file);
    visit("image_file", cell.image_file);
}

template <class Visit, RecordOf<RankRange> Record>
void visit_members(Visit& visit, Record& record) {
    visit("best", record.best);
    visit("worst", record.worst);
}

template <class Visit, RecordOf<PlaceRecord> Record>
void visit_members(Visit& visit, Record& record) {
    visit("method", record.method);
    visit("method_label", record.method_label);
    visit("preset", record.preset);
    visit("filter", record.filter);
    visit("cell_ids", record.cell_ids);
    visit("value", record.value);
    visit("interval", record.interval);
    visit("rank", record.rank);
    visit("ties", record.ties);
    visit("behind_first", record.behind_first);
    visit("measures", record.measures);
}

template <class Visit, RecordOf<RankingRecord> Record>
void visit_members(Visit& visit, Record& record) {
    visit("view_keys", record.view_keys);
    visit("radius_m", record.radius_m);
    visit("metric", record.metric);
    visit("places", record.places);
}

template <class Visit, RecordOf<ChangeRecord> Record>
void visit_members(Visit& visit, Record& record) {
    visit("cell_id", record.cell_id);
    visit("metric", record.metric);
    visit("before", record.before);
    visit("now", record.now);
    visit("change", record.change);
    visit("verdict", record.verdict);
    visit("reason", record.reason);
}

template <class Visit, RecordOf<BaselineRecord> Record>
void visit_members(Visit& visit, Record& record) {
    visit("program_version", record.program_version);
    visit("created_utc", record.created_utc);
    visit("command", record.command);
    visit("changes", record.changes);
}

template <class Visit, RecordOf<TableRecord> Record>
void visit_members(Visit& visit, Record& table) {
    visit("definition", table.definition);
    visit("cell_ids", table.cell_ids);
    visit.where_any("tuned", table.tuned);
}

template <class Visit, RecordOf<TunedRowRecord> Record>
void visit_members(Visit& visit, Record& row) {
    visit("step", row.step);
    visit("tuning", row.tuning);
}

template <class Visit, RecordOf<SweepPointRecord> Record>
void visit_members(Visit& visit, Record& point) {
    visit("cell_id", point.cell_id);
    visit("at", point.at);
}

template <class Visit, RecordOf<SweepRecord> Record>
void visit_members(Visit& visit, Record& sweep) {
    visit("definition", sweep.definition);
    visit("title", sweep.title);
    visit("axes", sweep.axes);
    visit("points", sweep.points);
    visit("budget_ms", sweep.budget_ms);
    visit("timing_confidence", sweep.timing_confidence);
    visit("notes", sweep.notes);
}

template <class Visit, RecordOf<StepRecord> Record>
void visit_members(Visit& visit, Record& step) {
    visit("id", step.id);
    visit("what", step.what);
    visit("error", step.error);
    visit("change", step.change);
    visit("verdict", step.verdict);
    visit("ms", step.ms);
    visit("ms_interval", step.ms_interval);
    visit("fetches", step.fetches);
    visit("reason", step.reason);
}

template <class Visit, RecordOf<SkippedStep> Record>
void visit_members(Visit& visit, Record& step) {
    visit("id", step.id);
    visit("reason", step.reason);
}

template <class Visit, RecordOf<AdviceRecord> Record>
void visit_members(Visit& visit, Record& advice) {
    visit("cell_id", advice.cell_id);
    visit("metric", advice.metric);
    visit("error", advice.error);
    visit("ms", advice.ms);
    visit("fixed_pass_ms", advice.fixed_pass_ms);
    visit("fetches", advice.fetches);
    visit("steps", advice.steps);
    visit("skipped", advice.skipped);
}

template <class Visit, RecordOf<ClaimFinding> Record>
void visit_members(Visit& visit, Record& finding) {
    visit("about", finding.about);
    visit("what", finding.what);
    visit("unit", finding.unit);
    visit("decimals", finding.decimals);
    visit("value", finding.value);
    visit("low", finding.low);
    visit("high", finding.high);
    visit("claimed_low", finding.claimed_low);
    visit("claimed_high", finding.claimed_high);
    visit("outcome", finding.outcome);
}

template <class Visit, RecordOf<ClaimRecord> Record>
void visit_members(Visit& visit, Record& claim) {
    visit("id", claim.id);
    visit("source", claim.source);
    visit("place", claim.place);
    visit("claim", claim.claim);
    visit("verdict", claim.verdict);
    visit("reason", claim.reason);
    visit("own", claim.own);
    visit("note", claim.note);
    visit("findings", claim.findings);
    visit("cell_ids", claim.cell_ids);
}

template <class Visit, RecordOf<WorkRecord> Record>
void visit_members(Visit& visit, Record& work) {
    visit("rays", work.rays);
    visit("gbuffers", work.gbuffers);
    visit("passes", work.passes);
    visit("compilations", work.compilations);
    visit("cells_measured", work.cells_measured);
    visit("cells_reused", work.cells_reused);
}

template <class Visit, RecordOf<Results> Record>
void visit_members(Visit& visit, Record& results) {
    visit("program_version", results.program_version);
    visit("created_utc", results.created_utc);
    visit("command", results.command);
    visit("cpu", results.cpu);
    visit("threads", results.threads);
    visit("gl_renderer", results.gl_renderer);
    visit("gl_version", results.gl_version);
    visit("seed", results.seed);
    visit("mask_threshold", results.mask_threshold);
    visit("work", results.work);
    visit("total_seconds", results.total_seconds);
    visit("peak_memory_mib", results.peak_memory_mib);
    visit("views", results.views);
    visit("cells", results.cells);
    visit("rankings", results.rankings);
    visit("baseline", results.baseline);
    visit("tables", results.tables);
    visit("sweeps", results.sweeps);
    visit("advice", results.advice);
    visit("claims", results.claims);
    visit("warnings", results.warnings);
}

}  // namespace aoscore
