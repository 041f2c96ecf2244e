#pragma once

#include "metrics/analysis/analysis.h"
#include "results/record_of.h"

/// The members of the records of an analysis, by key; see results_members.h.
namespace aoscore {

template <class Visit, RecordOf<Interval> Record>
void visit_members(Visit& visit, Record& record) {
    visit("low", record.low);
    visit("high", record.high);
}

template <class Visit, RecordOf<BestFit> Record>
void visit_members(Visit& visit, Record& record) {
    visit("strength", record.strength);
    visit("exponent", record.exponent);
    visit("rmse", record.rmse);
    visit("rmse_debiased", record.rmse_debiased);
    visit("bias", record.bias);
    visit("squared_sums", record.squared_sums);
}

template <class Visit, RecordOf<BinBlocks> Record>
void visit_members(Visit& visit, Record& record) {
    visit("counts", record.counts);
    visit("signed_sums", record.signed_sums);
}

template <class Visit, RecordOf<CauseShare> Record>
void visit_members(Visit& visit, Record& record) {
    visit("cause", record.cause);
    visit("area", record.area);
    visit("mean", record.mean);
}

template <class Visit, RecordOf<MaskSummary> Record>
void visit_members(Visit& visit, Record& record) {
    visit("area", record.area);
    visit("mean", record.mean);
    visit("causes", record.causes);
}

template <class Visit, RecordOf<ErrorRegion> Record>
void visit_members(Visit& visit, Record& record) {
    visit("kind", record.kind);
    visit("left", record.left);
    visit("top", record.top);
    visit("width", record.width);
    visit("height", record.height);
    visit("worst_x", record.worst_x);
    visit("worst_y", record.worst_y);
    visit("worst_error", record.worst_error);
    visit("area_px", record.area_px);
    visit("mean_error", record.mean_error);
    visit("cause", record.cause);
}

template <class Visit, RecordOf<SplitBin> Record>
void visit_members(Visit& visit, Record& record) {
    visit("label", record.label);
    visit("share", record.share);
    visit("error_share", record.error_share);
    visit("rmse", record.rmse);
    visit("bias", record.bias);
    visit("noise_rmse", record.noise_rmse);
}

template <class Visit, RecordOf<Split> Record>
void visit_members(Visit& visit, Record& record) {
    visit("id", record.id);
    visit("label", record.label);
    visit("unit", record.unit);
    visit("meaning", record.meaning);
    visit("bins", record.bins);
}

template <class Visit, RecordOf<ErrorDistribution> Record>
void visit_members(Visit& visit, Record& record) {
    visit("histogram_low", record.histogram_low);
    visit("histogram_high", record.histogram_high);
    visit("histogram", record.histogram);
    visit("cumulative_step", record.cumulative_step);
    visit("cumulative", record.cumulative);
}

template <class Visit, RecordOf<MapSums> Record>
void visit_members(Visit& visit, Record& record) {
    visit("ssim_sums", record.ssim_sums);
    visit("ssim_weights", record.ssim_weights);
    visit("flip_sums", record.flip_sums);
    visit("ms_ssim", record.ms_ssim);
    visit("ms_ssim_influences", record.ms_ssim_influences);
}

template <class Visit, RecordOf<BlockErrors> Record>
void visit_members(Visit& visit, Record& record) {
    visit("side_px", record.side_px);
    visit("across", record.across);
    visit("down", record.down);
    visit("counts", record.counts);
    visit("squared_sums", record.squared_sums);
    visit("absolute_sums", record.absolute_sums);
    visit("signed_sums", record.signed_sums);
    visit("variance_sums", record.variance_sums);
    visit("missing_counts", record.missing_counts);
    visit("false_counts", record.false_counts);
    visit("maps", record.maps);
}

template <class Visit, RecordOf<ErrorAnalysis> Record>
void visit_members(Visit& visit, Record& record) {
    visit("intervals", record.intervals);
    visit("fit", record.fit);
    visit("missing", record.missing);
    visit("false_occlusion", record.false_occlusion);
    visit("regions", record.regions);
    visit("splits", record.splits);
    visit("behind_edges", record.behind_edges);
    visit("distribution", record.distribution);
    visit("tile_pattern", record.tile_pattern);
    visit("found_beyond_layer", record.found_beyond_layer);
    visit("truth_noise", record.truth_noise);
    visit("blocks", record.blocks);
}

}  // namespace aoscore
