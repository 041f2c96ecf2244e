#include "page/synthetic_results.h"

#include "core/files.h"
#include "core/folders.h"
#include "core/strict_json.h"
#include "image/image_file.h"
#include "metrics/analysis/occlusion_masks.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace aoscore::testing {
namespace {

constexpr int kWidth = 192, kHeight = 108;

struct MethodFacts {
    const char* id;
    const char* label;
    double rmse;
    double ao_ms;
    double fetches;
    float shift;  // difference of its picture from the truth
};
constexpr MethodFacts kMethods[] = {{"crytek-ssao", "Crytek SSAO", 0.2, 100, 16, -0.2F},
                                    {"hbao-hussain", "HBAO (Hussain)", 0.08, 300, 36.5, 0.08F},
                                    {"alchemy", "Alchemy AO", 0.05, 80, 12, 0.05F}};

const MethodFacts& facts_of(const std::string& method) {
    for (const MethodFacts& facts : kMethods) {
        if (method == facts.id) return facts;
    }
    throw std::logic_error("no synthetic method " + method);
}

ViewRecord view_record(const std::string& view) {
    ViewRecord record;
    record.key = "atrium/" + view;
    record.scene = "atrium";
    record.view = view;
    record.scene_digest = "00112233445566778899aabbccddeeff";
    record.view_source = "scenes/atrium/views.json";
    record.triangles = 250123;
    record.width = kWidth;
    record.height = kHeight;
    record.position_m = {0, 1.7, 12};
    record.target_m = {0, 2.5, 0};
    record.up = {0, 1, 0};
    record.projection = "perspective";
    record.fovy_deg = 60;
    record.near_m = 0.1;
    record.far_m = 100;
    record.radius_m = 0.5;
    record.radius_rule = "named by the view";
    record.radius_px_median = 12.5;
    record.surface_pixels = kWidth * kHeight - 400;
    record.valid_pixels = kWidth * kHeight - 450;
    record.disagreeing_pixels = 2;
    record.edge_pixels = 300;
    record.truth_file = "views/atrium-" + view + "-truth.exr";
    record.gbuffer_file = "views/atrium-" + view + "-gbuffer.exr";
    record.samples = 64;
    record.truth_seconds = 3.5;
    record.least_samples = 64;
    record.integrator = "0123456789ab";
    record.truth_command = "aoscore reference atrium --view " + view + " --seed 1 --out truth.exr";
    record.truth_rays = record.truth_rays_now = 1234567;
    record.savings.left_out_triangles = 4321;
    record.gbuffer = {{10, 11, 12}, 11, 0.5};
    record.lighting = "Four lights";
    record.lighting_parameters = {{"lights", 4}};
    record.truths.push_back({"ranked", "binary", 0.5, {}, "V0.Y", "SE0.Y", 0.02, 0.031});
    record.truths.push_back({"quadratic-0.549", "quadratic", 0.549, {}, "V0.Y", "SE0.Y", 0.01, 0.02});
    record.truths.push_back({"alchemy-u0.128", "alchemy", {}, 0.128, "V0.Y", "SE0.Y", 0.01, 0.02});
    return record;
}

MetricMap metric_map(double rmse, double bias) {
    MetricMap map;
    map["rmse"] = {std::hypot(rmse, 0.031), ""};
    map["rmse_debiased"] = {rmse, ""};
    map["mae"] = {rmse * 0.8, ""};
    map["bias"] = {bias, ""};
    map["psnr"] = {-20 * std::log10(rmse), ""};
    map["ssim"] = {1 - rmse, ""};
    map["max_error"] = {0.61, "at 12, 40"};
    map["flip"] = {std::nullopt, "not measured in this run"};
    map["ms_ssim"] = {0.9, ""};
    return map;
}

ImageF truth_image() {
    ImageF image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float to_column = std::abs(static_cast<float>(x % 48) - 24.0F) / 24.0F;
            const float to_floor = static_cast<float>(kHeight - y) / kHeight;
            image.at(x, y) = 0.3F + 0.6F * std::min(1.0F, to_column + 0.5F * to_floor);
        }
    }
    return image;
}

ImageF shifted(ImageF image, float shift) {
    for (float& value : image.pixels) value = std::min(1.0F, std::max(0.0F, value + shift));
    return image;
}

CellRecord cell_record(const std::string& view, const MethodFacts& facts, const std::string& preset) {
    CellRecord cell;
    cell.view_key = "atrium/" + view;
    cell.id = cell.view_key + "/" + facts.id + "/" + preset;
    cell.method = facts.id;
    cell.method_label = facts.label;
    cell.preset = preset;
    cell.filter = preset == "quality" ? "none" : "box-4x4";
    cell.parameters = {{"samples", 16}, {"radius", 0.549}, {"range_check", true}};
    cell.lengths = {{"radius", 0.549, "m", preset == "quality" ? LengthRecord::kPreset : LengthRecord::kRun}};
    cell.own_truth = "quadratic-0.549";
    if (view == "close" && cell.method == "alchemy") {
        cell.error = "7 pixels are NaN or infinite";
        return cell;
    }
    cell.fixed_pass = {{50}, 50.0, 0.0, {}};
    cell.ao = {{facts.ao_ms - 1, facts.ao_ms, facts.ao_ms + 2}, facts.ao_ms, 1.0};
    if (cell.filter != "none") cell.filter_pass = {{5, 5.5, 6}, 5.5, 0.5};
    cell.lighting = {{8, 9, 10}, 9, 0.5};
    cell.frame = frame_of(11, 9, facts.ao_ms, cell.filter_pass.median_ms.value_or(0));
    cell.frame_ms = cell.frame->frame_ms;
    const ImageF truth = truth_image(), error(kWidth, kHeight, 0.02F);
    cell.analysis = analyse({truth, shifted(truth, facts.shift), Mask(kWidth, kHeight, 1), &error}, {},
                            kMaskThreshold, 1);
    cell.fetches_per_pixel = facts.fetches;
    const double rmse = preset == "quality" ? 0.8 * facts.rmse : facts.rmse;
    cell.ranked = metric_map(rmse, facts.shift);
    cell.own = metric_map(facts.rmse / 2, facts.shift / 2);
    if (cell.filter != "none") cell.raw = metric_map(facts.rmse * 1.5, facts.shift);
    cell.image_file = "cells/" + view + "-" + facts.id + "-" + preset + ".exr";
    return cell;
}

std::map<std::string, MeasureRecord> measures_of(const CellRecord& cell) {
    std::map<std::string, MeasureRecord> measures;
    for (const auto& [id, metric] : cell.ranked) {
        if (metric.value)
            measures[id] = {*metric.value, Interval{*metric.value - 0.002, *metric.value + 0.002}};
    }
    measures["max_error"].interval.reset();
    measures[kMissingArea] = {0.25, Interval{0.21, 0.29}};
    measures[kFalseArea] = {0.125, Interval{0.11, 0.14}};
    return measures;
}

/// One ranking a view, in which all methods differ significantly.
std::vector<RankingRecord> rankings_of(const std::vector<CellRecord>& cells) {
    std::vector<RankingRecord> rankings;
    for (const CellRecord& cell : cells) {
        if (!cell.analysis) continue;
        auto found = std::ranges::find_if(
            rankings, [&](const RankingRecord& r) { return r.view_keys.front() == cell.view_key; });
        if (found == rankings.end())
            found = rankings.insert(rankings.end(), {{cell.view_key}, 0.5, "rmse_debiased", {}});
        const double value = *cell.ranked.at("rmse_debiased").value;
        found->places.push_back({cell.method,
                                 cell.method_label,
                                 cell.preset,
                                 cell.filter,
                                 {cell.id},
                                 value,
                                 Interval{value - 0.002, value + 0.002},
                                 {},
                                 {},
                                 {},
                                 measures_of(cell)});
    }
    for (RankingRecord& ranking : rankings) {
        std::ranges::stable_sort(ranking.places, {}, &PlaceRecord::value);
        for (std::size_t i = 0; i < ranking.places.size(); ++i) {
            PlaceRecord& place = ranking.places[i];
            place.rank = RankRange{static_cast<int>(i) + 1, static_cast<int>(i) + 1};
            const double behind = place.value - ranking.places.front().value;
            if (i > 0) place.behind_first = Interval{behind - 0.001, behind + 0.001};
        }
    }
    return rankings;
}

}  // namespace

namespace {

SweepRecord sweep_of(const std::vector<CellRecord>& cells) {
    SweepRecord sweep;
    sweep.title = "A synthetic sweep";
    sweep.axes = {"samples"};
    sweep.budget_ms = 200;
    sweep.notes = {"directions does not apply and is left out"};
    int samples = 4;
    for (const CellRecord& cell : cells)
        sweep.points.push_back({cell.id, {{"method", cell.method}, {"samples", samples++}}});
    return sweep;
}

std::vector<ClaimRecord> claims_of(const std::vector<CellRecord>& cells) {
    ClaimRecord holds;
    holds.id = "T01";
    holds.source = "Author, Title, 2020";
    holds.place = "section 1";
    holds.claim = "One thing is less than the other.";
    holds.verdict = ClaimRecord::kHolds;
    holds.own = "Its table agrees.";
    holds.findings.push_back(
        {"what for", "AO pass: one less another", "ms", 2, 1.25, 1.0, 1.5, 0.0, {}, ClaimRecord::kHolds});
    holds.cell_ids = {cells.front().id};
    ClaimRecord fails = holds, open = holds;
    fails.id = "T02";
    fails.verdict = fails.findings.front().outcome = ClaimRecord::kFails;
    open.id = "T03";
    open.verdict = ClaimRecord::kCannotTell;
    open.reason = "it needs frames";
    open.findings.clear();
    return {holds, fails, open};
}

/// One step that costs time, one that does not and is a tie, one that failed, and one that was left out.
AdviceRecord advice_of(const CellRecord& cell) {
    AdviceRecord advice{cell.id, "rmse_debiased", 0.1, 8.0, 2.0, 16.0, {}, {}};
    advice.steps.push_back({"more-taps", "samples 16 to 32", 0.08, Interval{-0.025, -0.015},
                            StepRecord::kCloser, 4.0, Interval{3.9, 4.1}, 16.0, ""});
    advice.steps.push_back(
        {"best-strength", "", 0.1001, Interval{-0.001, 0.0012}, StepRecord::kTie, {}, {}, 0.0, "not timed"});
    advice.steps.push_back({"guard-band", "", {}, {}, StepRecord::kFailed, {}, {}, {}, "<7 pixels> differ"});
    advice.skipped.push_back({"no-filter", "no filter follows it"});
    return advice;
}

}  // namespace

Results synthetic_results() {
    Results results;
    results.program_version = std::string(version());
    results.created_utc = "2026-01-02T03:04:05Z";
    results.command = "aoscore run";
    results.cpu = "Synthetic CPU";
    results.threads = 2;
    results.gl_renderer = "llvmpipe (synthetic)";
    results.gl_version = "4.5 (Core Profile)";
    results.seed = 1;
    results.total_seconds = 42;
    results.peak_memory_mib = 512;
    results.warnings = {"a synthetic warning"};
    results.views = {view_record("wide"), view_record("close")};
    for (const MethodFacts& facts : kMethods) {
        results.cells.push_back(cell_record("wide", facts, "performance-wide"));
        results.cells.push_back(cell_record("wide", facts, "quality"));
        results.cells.push_back(cell_record("close", facts, "performance-close"));
    }
    results.rankings = rankings_of(results.cells);
    results.sweeps = {sweep_of(results.cells)};
    results.claims = claims_of(results.cells);
    for (const CellRecord& cell : results.cells) results.advice.push_back(advice_of(cell));
    for (const char* id : {"hussain-table-3", "hussain-table-4", "hussain-table-5"}) {
        TableRecord table;
        table.definition = parse_json_file(data_dir() / "reports" / (std::string(id) + ".json"));
        for (const nlohmann::json& row : table.definition.at("rows")) {
            table.cell_ids.push_back("atrium/" + table.definition.at("view").get<std::string>() + "/" +
                                     row.at("method").get<std::string>() + "/" +
                                     row.at("preset").get<std::string>());
        }
        results.tables.push_back(std::move(table));
    }
    return results;
}

Results without_pictures(Results results) {
    for (ViewRecord& view : results.views) view.truth_file = view.gbuffer_file = "";
    for (CellRecord& cell : results.cells) cell.image_file = "";
    return results;
}

void write_synthetic(const Results& results, const std::filesystem::path& folder) {
    const ImageF truth = truth_image();
    const ImageF error(kWidth, kHeight, 0.02F);
    ImageF mask(kWidth, kHeight, 1.0F), depth = truth;
    for (int x = 0; x < kWidth; ++x) mask.at(x, 0) = 0;
    for (float& z : depth.pixels) z = 2 + 10 * z;
    for (const ViewRecord& view : results.views) {
        if (view.truth_file.empty()) continue;
        const std::vector<ChannelView> channels = {
            {"Y", &truth}, {"V0.Y", &truth}, {"SE0.Y", &error}, {"mask.Y", &mask}};
        write_exr(folder / view.truth_file, channels, {});
        write_exr(folder / view.gbuffer_file, std::vector<ChannelView>{{"Y", &depth}, {"Z", &depth}}, {});
    }
    std::mt19937 random(5);
    for (const CellRecord& cell : results.cells) {
        if (cell.image_file.empty()) continue;
        const ImageF output = shifted(truth, facts_of(cell.method).shift);
        ImageF raw = truth;
        for (std::size_t i = 0; i < output.size(); ++i) {
            const float noise = static_cast<float>(random() % 1000) / 10000.0F - 0.05F;
            raw.pixels[i] = std::min(1.0F, std::max(0.0F, output.pixels[i] + noise));
        }
        std::vector<ChannelView> channels = {{"Y", &output}};
        if (cell.filter != "none") channels.push_back({"raw.Y", &raw});
        write_exr(folder / cell.image_file, channels, {});
    }
    write_results(results, folder);
}

}  // namespace aoscore::testing
