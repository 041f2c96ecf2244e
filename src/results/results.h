#pragma once

#include "core/parameter_value.h"
#include "metrics/analysis/analysis.h"
#include "metrics/analysis/repeats.h"
#include "metrics/intervals/simultaneous.h"
#include "metrics/metric.h"
#include "results/advice.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The results of one run, from which alone its page is made. They are stored as results.json beside their
/// images, EXR files; paths are relative to that folder. Missing numbers are empty, never NaN.

using MeasuredMetric = MetricValue;
using MetricMap = std::map<std::string, MeasuredMetric>;  ///< by metric id

/// Times of repeated runs after warm-up, in milliseconds.
struct Timing {
    std::vector<double> runs_ms;
    std::optional<double> median_ms;  ///< empty without runs
    std::optional<double> spread_ms;  ///< half the distance between the quartiles
    /// The same runs as processor time of all threads; empty where it was not taken.
    std::vector<double> processor_runs_ms = {};
};

/// The id of the truth by which all methods of a view are ranked.
inline constexpr char kRankedTruth[] = "ranked";

/// A truth that images were compared with.
struct TruthRecord {
    std::string id;                  ///< "ranked", or the method's own, such as "quadratic-0.549"
    std::string falloff;             ///< "binary", "quadratic", "alchemy", "xegtao"
    std::optional<double> radius_m;  ///< empty for infinity
    std::optional<double> u_m;       ///< u of the falloff "alchemy"
    std::string channel;             ///< its channel in the truth file: "V0.Y"; empty where it is in no file
    std::string se_channel;  ///< the standard error's: "SE0.Y"; empty likewise, and where it is unknown
    double mean_standard_error = 0;  ///< over valid pixels; 0 where it is unknown
    double noise_floor_rmse = 0;     ///< sqrt of the mean variance: the RMSE a perfect method would show
    int samples = 0;                 ///< rays a pixel, as in ViewRecord::samples
};

/// A signal beside visibility that a view's truth holds, in the channels that core/signal.h names.
struct SignalRecord {
    std::string id;                      ///< "bent_normal"
    double mean_standard_error_deg = 0;  ///< mean standard error of its angle, over known pixels
    std::size_t known_pixels = 0;        ///< valid pixels certain enough to count (metrics/angle_errors.h)
};

/// A measured number with its interval.
struct MeasureRecord {
    double value = 0;
    std::optional<Interval> interval;  ///< 95 % confidence; empty where nothing can be resampled
};

/// The ray-traced irradiance of a view under an environment.
struct LightRecord {
    std::string environment;  ///< "sky", or how the command names the picture
    std::string file;  ///< EXR: R, G, B, the irradiance over pi; half_difference.R…, of two estimates
    double mean = 0;   ///< its luminance over valid pixels
    double standard_error = 0;  ///< root mean variance of that luminance, in the same unit
    int samples = 0;            ///< rays a pixel
    /// The errors of lighting by the truth's own visibility, bent normal and cone, as CellRecord::light has
    /// them: what is left of them where a method makes no error.
    std::map<std::string, MeasureRecord> of_truth;
};

/// The part of the ranking's occlusion that has one cause (see comparison by cause in references/README.md).
struct CauseRecord {
    std::string id;             ///< "outside", "hidden", "grazing", "visible"
    std::string channel;        ///< its channel in the truth file: "cause.outside.Y"
    double mean_occlusion = 0;  ///< over valid pixels; the causes add up to the mean occlusion
};

/// The rays that a view's truth saved, against giving every pixel as many as the pixel that got most: those
/// savings and ViewRecord::truth_rays add up to width x height x most_samples.
struct TruthSavings {
    std::uint64_t most_samples = 0;        ///< rays of the pixel that got most
    std::uint64_t background_rays = 0;     ///< saved where there is no surface
    std::uint64_t open_rays = 0;           ///< saved on pixels proven open
    std::uint64_t converged_rays = 0;      ///< saved on pixels that converged earlier
    std::uint64_t tiles = 0;               ///< number of tiles of 8x8 pixels
    std::uint64_t untraced_tiles = 0;      ///< tiles where no pixel needed a ray
    std::uint64_t left_out_triangles = 0;  ///< beyond the radius of all visible surfaces, and so not
                                           ///< built for tracing; 0 where nothing was built
};

struct ViewRecord {
    std::string key;  ///< "atrium/wide": names the view everywhere in this file
    std::string scene;
    std::string view;
    std::string scene_digest;
    std::string view_source;
    std::string view_note;
    std::size_t triangles = 0;
    int width = 0, height = 0;
    std::vector<double> position_m, target_m, up;  ///< three numbers each, world
    std::string projection;                        ///< "perspective" or "orthographic"
    double fovy_deg = 0;                           ///< perspective
    double half_height_m = 0;                      ///< orthographic
    double near_m = 0, far_m = 0;
    double radius_m = 0;          ///< the ranking's, which methods' lengths follow
    std::string radius_rule;      ///< its origin: "2 % of the scene's diagonal"
    double radius_px_median = 0;  ///< the radius in pixels, median over valid pixels
    std::size_t surface_pixels = 0;
    std::size_t valid_pixels = 0;        ///< pixels whose surface both paths see alike
    std::size_t disagreeing_pixels = 0;  ///< non-edge pixels that break the contract
    std::size_t edge_pixels = 0;         ///< exempt from the contract
    std::string truth_file;              ///< EXR: V0.Y…, SE0.Y…, mask.Y (1 = valid)
    std::string gbuffer_file;            ///< EXR: Z, N.X…, Ns.X…; empty when not kept
    std::vector<TruthRecord> truths;     ///< the first is the ranking's
    std::vector<CauseRecord> causes;     ///< parts of the ranking's occlusion; empty where not traced
    std::vector<SignalRecord> signals;   ///< signals beside visibility; empty where none was asked for
    std::optional<LightRecord> light;    ///< empty where nothing is lit by an environment
    std::string one_layer_channel;       ///< channel of the truth file with the occlusion that one depth
                                         ///< layer can show at most; empty where not traced
    int samples = 0;                     ///< rays a pixel (the mean where they differ)
    std::optional<double> max_error;     ///< the standard error that every pixel was traced to
    bool halves = false;                 ///< the rays are two independent halves, which debias the scores
    /// The half width of an RMSE's interval by the truth's noise, where that decided the rays.
    std::optional<double> score_error;
    bool final_answer = true;     ///< false for the first answer of a run that goes on
    std::size_t open_pixels = 0;  ///< proven open without tracing a ray
    double truth_seconds = 0;
    /// "traced", "resumed" after an interruption, "refined" from fewer rays, "cached" when not traced again,
    /// or "given" where the truth is a file and the view a frame without its scene.
    std::string truth_origin = "traced";
    /// The request that the truth was made for, by an earlier run where it is cached: it may exceed this
    /// run's.
    int least_samples = 0;             ///< least rays of a pixel that got any
    std::string integrator;            ///< digest of the code that made the truth
    std::string truth_command;         ///< traces the ranking's truth, and those of other binary radii, again
    std::uint64_t truth_rays_now = 0;  ///< rays traced in this run
    std::uint64_t truth_rays = 0;      ///< all rays of the truth
    std::size_t background_pixels = 0;  ///< pixels without surface
    TruthSavings savings;
    Timing gbuffer;
    std::string lighting;                 ///< the lighting pass's label; empty where none was timed
    ParameterValues lighting_parameters;  ///< all of them, by id
    std::vector<std::string> warnings;
};

/// A frame with lighting: the medians of its passes, and numbers computed from them.
struct FrameRecord {
    double geometry_ms = 0;           ///< the G-buffer
    double lighting_ms = 0;           ///< the lighting pass
    double geometry_lighting_ms = 0;  ///< the sum of both: a frame without AO
    double ao_ms = 0;                 ///< the AO pass
    double filter_ms = 0;             ///< the filter; 0 without one
    double frame_ms = 0;              ///< the sum of all passes
    double geometry_lighting_share = 0, ao_share = 0, filter_share = 0;  ///< of frame_ms; they add up to 1
    double per_second = 0;                                               ///< frames a second
    double per_second_without_ao = 0;  ///< frames of geometry and lighting alone
    double per_second_unfiltered = 0;  ///< frames without the filter
};
/// Computes a frame from its passes in milliseconds. `geometry_ms` must be above 0.
FrameRecord frame_of(double geometry_ms, double lighting_ms, double ao_ms, double filter_ms);

/// A length of a method or its filter in a run.
struct LengthRecord {
    static constexpr const char* kRun = "run";        ///< follows the view's radius
    static constexpr const char* kOwn = "own";        ///< the descriptor's, whatever the radius
    static constexpr const char* kPreset = "preset";  ///< the preset's, whatever the radius
    static constexpr const char* kSet = "set";        ///< set by the command or experiment
    std::string id;                                   ///< its parameter: "radius", "filter.distance_unit"
    double value = 0;
    std::string unit;    ///< "m", "m2"
    std::string origin;  ///< one of the four above
};
/// The purpose of a method ("role" in its descriptor): to be used, or, as a bound, to show how far others
/// could go. A bound is named as such in tables and charts; it has no rank and is on no front.
inline constexpr const char* kMethodRole = "method";
inline constexpr const char* kBoundRole = "bound";

/// One scene x view x method x preset.
struct CellRecord {
    std::string id;  ///< unique in the run: "atrium/wide/hbao/performance-wide"
    std::string view_key;
    std::string method;              ///< the method's id
    std::string method_label;        ///< a bound's ends in "(bound)"
    std::string role = kMethodRole;  ///< or kBoundRole
    std::string preset;
    std::string setting;                ///< changes of the preset: "noise none"
    std::string filter;                 ///< "none" or a filter's id
    ParameterValues parameters;         ///< all of them, by id
    std::vector<LengthRecord> lengths;  ///< lengths among them and the filter's
    std::string error;                  ///< why the cell failed; else empty
    Timing ao, filter_pass;
    /// The part of the AO pass' processor time that draws the method's depth layers; no runs where it reads
    /// none.
    Timing layers_processor;
    Timing fixed_pass;  ///< sixteen fetches a pixel, timed in the same rounds; no runs where nothing was
    Timing lighting;    ///< the lighting pass, timed in the same rounds; no runs where not asked for
    Timing gbuffer;     ///< its G-buffer with the guard band, in place of the view's; no runs without one
    std::optional<double> gbuffer_bytes;  ///< of the G-buffer, with the guard band; empty where not timed
    /// Of the depth layers that it reads, side cameras' too, with the guard band; empty where it reads none.
    std::optional<double> layer_bytes;
    std::optional<double> frame_ms;  ///< G-buffer + AO + filter + lighting where it was timed, medians added
    std::optional<FrameRecord> frame;         ///< set where lighting was timed
    Timing frame_at_once, frame_by_pass;      ///< whole frames, waited for at the end or after every pass; no
                                              ///< runs where not asked for
    std::optional<double> fetches_per_pixel;  ///< by the AO pass, mean over valid pixels
    std::size_t nonfinite = 0;
    std::string ranked_truth = "ranked";
    std::string own_truth;  ///< its id among the view's truths
    MetricMap ranked;       ///< metrics against the ranking's truth
    MetricMap own;          ///< metrics against the method's own truth
    MetricMap raw;          ///< ranked metrics of the unfiltered output; empty without a filter
    /// Metrics of signals beside visibility against the truth's (see metrics/signal_metric.h), by their ids.
    /// Empty where none was asked for, or the method gives none.
    std::map<std::string, MetricMap> signals;
    std::optional<ErrorAnalysis> analysis;  ///< against the ranking's truth; empty for a failed cell
    std::optional<Repeats> repeats;         ///< empty where they were not asked for
    /// The errors of its light under the view's environment by every light mode that it has the signals for:
    /// "rmse.MODE" of luminance, "relative_rmse.MODE" and "bias.MODE" over the mean of the traced irradiance,
    /// "gain.MODE", what it takes off the rmse of the mode before. Empty where they were not asked for.
    std::map<std::string, MeasureRecord> light;
    std::string lit_file;    ///< EXR: the channels of LightMode::channels(); empty when not kept
    std::string image_file;  ///< EXR: Y (output), raw.Y (before the filter), channels of its signals; empty
                             ///< when not kept
};

/// The method's label, with its setting where it has one: "Alchemy AO, noise none".
std::string shown_name(const CellRecord& cell);

/// One method with its settings in a ranking.
struct PlaceRecord {
    std::string method;
    std::string method_label;  ///< the label with its setting
    std::string preset;
    std::string filter;
    std::vector<std::string> cell_ids;  ///< one for each of the ranking's views
    double value = 0;                   ///< the ranking's metric over the views, by measure_over_views()
    std::optional<Interval> interval;   ///< of this value alone, 95 % confidence; empty where not known
    std::optional<RankRange> rank;      ///< all ranks hold at once; empty for a bound
    std::vector<std::size_t> ties;      ///< ranked places that do not differ significantly
    /// The interval of this value less the first ranked place's, simultaneous with all others of the ranking;
    /// empty for the first place and for bounds.
    std::optional<Interval> behind_first;
    /// Every metric and mask area that all of the cells have, by id (kMissingArea, kFalseArea for areas).
    std::map<std::string, MeasureRecord> measures;
};

/// The rank: "2", "1–3" where it is uncertain, "bound" without a rank.
std::string rank_text(const PlaceRecord& place);

/// Ranks all cells that succeeded on one view, whatever their presets, or on each of a group of views (see
/// comparable_views()).
struct RankingRecord {
    std::vector<std::string> view_keys;
    double radius_m = 0;              ///< the radius of the ranking
    std::string metric;               ///< see ranking_metric()
    std::vector<PlaceRecord> places;  ///< by value, least error first; without failed cells
};

/// One cell compared with its cell in an earlier run.
struct ChangeRecord {
    std::string cell_id;
    std::string metric;            ///< see ranking_metric()
    std::optional<double> before;  ///< the earlier run's value
    std::optional<double> now;
    /// The interval of now - before, paired; all of a run hold together with 95 % confidence. Empty where not
    /// comparable.
    std::optional<Interval> change;
    /// "better" or "worse" where the interval excludes 0, "same" where it does not, "worse" for a cell that
    /// failed only now, else "not comparable".
    std::string verdict;
    std::string reason;  ///< why not comparable, or how it failed
};

/// The comparison with an earlier run.
struct BaselineRecord {
    std::string program_version;
    std::string created_utc;
    std::string command;
    std::vector<ChangeRecord> changes;  ///< one for each cell of this run
};

/// The step from a table's row to the preset `tuned` of its method, at as many taps.
struct TunedRowRecord {
    AdviceRecord step;      ///< from the row's cell: one step, or why there is none
    nlohmann::json tuning;  ///< how the preset was tuned, as in the method's tuned.json; null without one
};

/// A published table rebuilt: its definition (reports/<id>.json) with the cell of each row.
struct TableRecord {
    nlohmann::json definition;          ///< as it was read
    std::vector<std::string> cell_ids;  ///< one for each row of the definition
    std::vector<TunedRowRecord> tuned;  ///< one for each row; empty in a first answer and in older files
};

/// One setting of a sweep: its cell, and its values on the axes.
struct SweepPointRecord {
    std::string cell_id;
    ParameterValues at;  ///< value by axis; an axis that does not apply is missing
};

/// Methods over the product of some axes.
struct SweepRecord {
    nlohmann::json definition;  ///< reports/<id>.json as read; null for the command line
    std::string title;
    std::vector<std::string> axes;
    std::vector<SweepPointRecord> points;
    std::optional<double> budget_ms;  ///< limit for the AO pass with its filter
    double timing_confidence = 0.95;  ///< confidence of the medians' intervals
    std::vector<std::string> notes;   ///< axes and presets left out, with the reason
};

/// One measured part of a claim: a number with the interval that 95 % of repetitions would give, and its
/// claimed range.
struct ClaimFinding {
    std::string about;  ///< its meaning; may be empty
    std::string what;   ///< "AO pass: Alchemy AO (...) over HBAO (...)"
    std::string unit;
    int decimals = 2;  ///< decimals for printing
    std::optional<double> value, low, high;
    std::optional<double> claimed_low, claimed_high;
    std::string outcome;  ///< as ClaimRecord::verdict
};

/// A statement of a source, with the verdict on it.
struct ClaimRecord {
    static constexpr const char* kHolds = "holds";
    static constexpr const char* kFails = "does not hold";
    static constexpr const char* kCannotTell = "cannot be told here";
    std::string id;       ///< "H01"
    std::string source;   ///< author, title, year
    std::string place;    ///< place in the source
    std::string claim;    ///< in our own words
    std::string verdict;  ///< one of the three above
    std::string reason;   ///< why it cannot be decided
    std::string own;      ///< how the source's printed numbers differ; empty where they agree
    std::string note;     ///< how our measurement differs from the source's
    std::vector<ClaimFinding> findings;
    std::vector<std::string> cell_ids;  ///< cells measured for it
};

/// The work of a run, and the work that it found done.
struct WorkRecord {
    /// Rays traced for truths while these results were made, without those of a first answer before them.
    std::uint64_t rays = 0;
    std::uint64_t gbuffers = 0;      ///< G-buffers drawn
    std::uint64_t passes = 0;        ///< passes of methods, filters and lighting drawn
    std::uint64_t compilations = 0;  ///< shader programs compiled
    std::size_t cells_measured = 0;
    std::size_t cells_reused = 0;  ///< measured by an earlier run
};

struct Results {
    static constexpr int kSchemaVersion = 11;
    int schema_version = kSchemaVersion;  ///< of the file they were read from; written is kSchemaVersion
    std::string program_version;
    std::string created_utc;  ///< 2026-11-22T02:11:47Z
    std::string command;      ///< the command that runs it again
    std::string cpu;
    int threads = 0;
    std::string gl_renderer;
    std::string gl_version;
    std::uint64_t seed = 0;
    double mask_threshold = 0.1;  ///< for missing and false occlusion, in visibility
    WorkRecord work;
    double total_seconds = 0;
    double peak_memory_mib = 0;
    std::vector<ViewRecord> views;
    std::vector<CellRecord> cells;
    std::vector<RankingRecord> rankings;     ///< one for each view, then those over groups
    std::optional<BaselineRecord> baseline;  ///< empty where none was asked for
    std::vector<TableRecord> tables;
    std::vector<SweepRecord> sweeps;
    std::vector<AdviceRecord> advice;
    std::vector<ClaimRecord> claims;
    std::vector<std::string> warnings;
};

/// Write and read single records, for the artifact store. Readers throw file_error as results_from_json()
/// does.
nlohmann::json to_json(const ViewRecord& view);
nlohmann::json to_json(const CellRecord& cell);
ViewRecord view_record_from_json(const nlohmann::json& json, const std::string& where);
CellRecord cell_record_from_json(const nlohmann::json& json, const std::string& where);

nlohmann::json to_json(const Results& results);
nlohmann::json to_json(const ErrorAnalysis& analysis);
/// Results of an older schema are upgraded (see results/upgrade/). Throws file_error for a newer one, one
/// that is too old, or a missing member. `where` names the file in errors.
Results results_from_json(const nlohmann::json& json, const std::string& where);

/// Writes folder/results.json.
void write_results(const Results& results, const std::filesystem::path& folder);
/// Reads results; `path` is results.json, or its folder.
Results read_results(const std::filesystem::path& path);

}  // namespace aoscore
