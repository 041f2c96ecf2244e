#pragma once

#include "core/parameter_value.h"
#include "metrics/analysis/analysis.h"
#include "metrics/intervals/simultaneous.h"
#include "metrics/metric.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Everything one run measured: the only thing a page is made of. Kept as results.json with its images
/// beside it as EXR files; paths in it are relative to that folder. Numbers that could not be had are empty,
/// never NaN.

using MeasuredMetric = MetricValue;
using MetricMap = std::map<std::string, MeasuredMetric>;  ///< by metric id

/// Milliseconds of repeated runs after warm-up.
struct Timing {
    std::vector<double> runs_ms;
    std::optional<double> median_ms;  ///< empty without runs
    std::optional<double> spread_ms;  ///< half the distance between the quartiles
};

/// The id of the truth that all methods of a view are ranked by.
inline constexpr char kRankedTruth[] = "ranked";

/// One truth that a test image was held against.
struct TruthRecord {
    std::string id;                  ///< "ranked", or the method's own, such as "quadratic-0.549"
    std::string falloff;             ///< "binary", "quadratic", "alchemy", "xegtao"
    std::optional<double> radius_m;  ///< empty for infinity
    std::optional<double> u_m;       ///< of the falloff "alchemy"
    std::string channel;             ///< of the view's truth file: "V0.Y"; empty where it is in no file
    std::string se_channel;          ///< "SE0.Y"; empty likewise
    double mean_standard_error = 0;  ///< over valid pixels
    double noise_floor_rmse = 0;     ///< sqrt of the mean variance: the RMSE a perfect method would show
    int samples = 0;                 ///< rays a pixel, as in ViewRecord::samples
};

/// A signal beside visibility that a view's truth holds, in the channels that core/signal.h names.
struct SignalRecord {
    std::string id;                      ///< "bent_normal"
    double mean_standard_error_deg = 0;  ///< of its angle, over the pixels that count
    std::size_t known_pixels = 0;        ///< valid, and sure enough to count: see metrics/angle_errors.h
};

/// The part of the ranking's occlusion that has one cause (see comparison by cause in references/README.md).
struct CauseRecord {
    std::string id;             ///< "outside", "hidden", "grazing", "visible"
    std::string channel;        ///< of the view's truth file: "cause.outside.Y"
    double mean_occlusion = 0;  ///< over valid pixels; the causes add up to the mean occlusion
};

/// What a view's truth did not need to trace, as rays saved against giving every pixel of the picture as many
/// as the pixel that got most: those savings and ViewRecord::truth_rays add up to width x height x
/// most_samples.
struct TruthSavings {
    std::uint64_t most_samples = 0;        ///< rays of the pixel that got most
    std::uint64_t background_rays = 0;     ///< saved on pixels without surface
    std::uint64_t open_rays = 0;           ///< saved on pixels proven open
    std::uint64_t converged_rays = 0;      ///< saved on pixels that were sure enough earlier
    std::uint64_t tiles = 0;               ///< of 8x8 pixels
    std::uint64_t untraced_tiles = 0;      ///< of these, where no pixel needed a ray
    std::uint64_t left_out_triangles = 0;  ///< out of reach of all that the camera sees, and so not built for
                                           ///< tracing; 0 where nothing was built for this view
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
    double radius_m = 0;          ///< of the ranking, which methods are drawn for
    std::string radius_rule;      ///< where it comes from: "2 % of the scene's diagonal"
    double radius_px_median = 0;  ///< that radius, projected, median over valid pixels
    std::size_t surface_pixels = 0;
    std::size_t valid_pixels = 0;        ///< surface in both paths, camera contract kept
    std::size_t disagreeing_pixels = 0;  ///< non-edge pixels that break the contract
    std::size_t edge_pixels = 0;         ///< left out of the contract
    std::string truth_file;              ///< EXR: V0.Y…, SE0.Y…, mask.Y (1 = valid)
    std::string gbuffer_file;            ///< EXR: Z, N.X…, Ns.X…; empty when not kept
    std::vector<TruthRecord> truths;     ///< the first is the ranking's
    std::vector<CauseRecord> causes;     ///< of the ranking's occlusion; empty where they were not traced
    std::vector<SignalRecord> signals;   ///< beside visibility; empty where none was asked for
    std::string one_layer_channel;    ///< of the truth file: what a method that knows one depth layer could
                                      ///< find of the ranking's occlusion; empty where it was not traced
    int samples = 0;                  ///< rays a pixel (the mean where they differ)
    std::optional<double> max_error;  ///< the standard error that every pixel was traced to
    bool halves = false;  ///< the rays are two independent halves, from which noise is taken off the scores
    /// The half width that the truth's noise may give an RMSE, where that decided the rays.
    std::optional<double> score_error;
    bool final_answer = true;     ///< false where only the ranking was asked for, and the run goes on
    std::size_t open_pixels = 0;  ///< proven open without tracing a ray
    double truth_seconds = 0;
    /// "traced", "resumed" after an interruption, "refined" from fewer rays, or "cached": not traced again.
    std::string truth_origin = "traced";
    /// What the truth was made for, which may be more than this run asked for; where it came from the cache,
    /// by an earlier run.
    int least_samples = 0;   ///< rays that every pixel got which got any
    std::string integrator;  ///< digest of the code that makes truths: other code may make other bits
    std::string
        truth_command;  ///< that traces the truth of the ranking again, and those of other binary radii
    std::uint64_t truth_rays_now = 0;   ///< traced in this run
    std::uint64_t truth_rays = 0;       ///< that the truth is made of
    std::size_t background_pixels = 0;  ///< without surface
    TruthSavings savings;
    Timing gbuffer;
    std::string lighting;                 ///< the lighting pass's label; empty where none was timed
    ParameterValues lighting_parameters;  ///< all of them, by id
    std::vector<std::string> warnings;
};

/// A frame with its lighting, made of the medians of its passes, and what follows from them.
struct FrameRecord {
    double geometry_ms = 0;                                              ///< the G-buffer
    double lighting_ms = 0;                                              ///< the lighting pass
    double geometry_lighting_ms = 0;                                     ///< both: a frame without AO
    double ao_ms = 0;                                                    ///< the AO pass
    double filter_ms = 0;                                                ///< 0 without a filter
    double frame_ms = 0;                                                 ///< all of them
    double geometry_lighting_share = 0, ao_share = 0, filter_share = 0;  ///< of frame_ms; they add up to 1
    double per_second = 0;                                               ///< frames
    double per_second_without_ao = 0;  ///< frames of geometry and lighting alone
    double per_second_unfiltered = 0;  ///< frames without the filter
};
/// All of it from its passes, milliseconds. `geometry_ms` must be above 0.
FrameRecord frame_of(double geometry_ms, double lighting_ms, double ao_ms, double filter_ms);

/// A length of a method or its filter as it was drawn.
struct LengthRecord {
    static constexpr const char* kRun = "run";        ///< drawn for the view's radius
    static constexpr const char* kOwn = "own";        ///< the descriptor's, whatever the radius
    static constexpr const char* kPreset = "preset";  ///< the preset's, whatever the radius
    static constexpr const char* kSet = "set";        ///< by the command or experiment
    std::string id;                                   ///< the parameter's: "radius", "filter.distance_unit"
    double value = 0;
    std::string unit;    ///< "m", "m2"
    std::string origin;  ///< one of the four above
};
/// What a method is for: to be used, or to show how far others could go ("role" in its descriptor). A bound
/// stands in tables and charts under a name that says so; it has no rank, leads nothing and is on no front.
inline constexpr const char* kMethodRole = "method";
inline constexpr const char* kBoundRole = "bound";

/// One scene x view x method x preset.
struct CellRecord {
    std::string id;  ///< unique: "atrium/wide/hbao/performance-wide"
    std::string view_key;
    std::string method;              ///< id
    std::string method_label;        ///< a bound's ends in "(bound)"
    std::string role = kMethodRole;  ///< or kBoundRole
    std::string preset;
    std::string setting;                ///< what is not as the preset has it, "noise none"
    std::string filter;                 ///< "none" or a filter's id
    ParameterValues parameters;         ///< all of them, by id
    std::vector<LengthRecord> lengths;  ///< those of them, and of the filter's, that are lengths
    std::string error;                  ///< why the cell failed; empty when it did not
    Timing ao, filter_pass;
    std::optional<double> fixed_pass_ms;  ///< sixteen fetches a pixel, timed in the same rounds
    Timing lighting;  ///< the lighting pass, timed in the same rounds; no runs where not asked for
    std::optional<double> frame_ms;  ///< G-buffer + AO + filter + lighting where it was timed, medians added
    std::optional<FrameRecord> frame;         ///< where lighting was timed
    Timing frame_at_once, frame_by_pass;      ///< whole frames, waited for at the end or after every pass; no
                                              ///< runs where not asked for
    std::optional<double> fetches_per_pixel;  ///< of the AO pass, mean over valid pixels
    std::size_t nonfinite = 0;
    std::string ranked_truth = "ranked";
    std::string own_truth;  ///< id in the view's truths
    MetricMap ranked;       ///< against the ranking's truth
    MetricMap own;          ///< against the method's own radius and falloff
    MetricMap raw;          ///< ranked metrics of the unfiltered output; empty without a filter
    /// Of signals beside visibility, by their ids: metrics against the truth's (see metrics/signal_metric.h).
    /// Empty where none was asked for, or the method gives none.
    std::map<std::string, MetricMap> signals;
    std::optional<ErrorAnalysis> analysis;  ///< against the ranking's truth; empty for a failed cell
    std::string image_file;  ///< EXR: Y (output), raw.Y (before the filter), channels of its signals; empty
                             ///< when not kept
};

/// The method as readers know it, with its setting where it has one: "Alchemy AO, noise none".
std::string shown_name(const CellRecord& cell);

/// A metric or a mask's area of one method over a ranking's views, and how sure it is.
struct MeasureRecord {
    double value = 0;
    std::optional<Interval> interval;  ///< 95 % confidence; empty for what cannot be resampled
};

/// One method with its settings in a ranking.
struct PlaceRecord {
    std::string method;
    std::string method_label;  ///< with its setting
    std::string preset;
    std::string filter;
    std::vector<std::string> cell_ids;  ///< one for each of the ranking's views
    double value = 0;                   ///< the ranking's metric over the views, by measure_over_views()
    Interval interval;                  ///< of it alone, 95 % confidence
    std::optional<RankRange> rank;      ///< those of a ranking hold together; empty for a bound
    std::vector<std::size_t> ties;      ///< ranked places that it cannot be told apart from
    /// Of value - the first ranked place's, simultaneous with all others of the ranking; empty for that one,
    /// and for bounds.
    std::optional<Interval> behind_first;
    /// Of every metric and mask area that all of the cells have, by id (kMissingArea, kFalseArea for areas).
    std::map<std::string, MeasureRecord> measures;
};

/// "2", "1–3" where it cannot be told surely, "bound" without a rank.
std::string rank_text(const PlaceRecord& place);

/// Everything that succeeded on one view, whatever its preset, or on each of several views that one number
/// may cover (see comparable_views()).
struct RankingRecord {
    std::vector<std::string> view_keys;
    double radius_m = 0;              ///< at which all of them are ranked
    std::string metric;               ///< see ranking_metric()
    std::vector<PlaceRecord> places;  ///< by value, closest first; cells that failed are left out
};

/// One cell against the cell of the same id in an earlier run.
struct ChangeRecord {
    std::string cell_id;
    std::string metric;            ///< see ranking_metric()
    std::optional<double> before;  ///< of the earlier run
    std::optional<double> now;
    /// Of now - before, paired; all changes of a run hold together with 95 % confidence. Empty where not
    /// comparable.
    std::optional<Interval> change;
    /// "better" or "worse" where the interval leaves 0 out, "same" where it does not, "worse" for a cell that
    /// failed now alone, "not comparable" else.
    std::string verdict;
    std::string reason;  ///< why not comparable, or how it failed
};

/// An earlier run, as far as this one was held against it.
struct BaselineRecord {
    std::string program_version;
    std::string created_utc;
    std::string command;
    std::vector<ChangeRecord> changes;  ///< one a cell of this run
};

/// A published table rebuilt: the definition (reports/<id>.json) and which cell stands for each of its rows.
struct TableRecord {
    nlohmann::json definition;          ///< as read, without change
    std::vector<std::string> cell_ids;  ///< one for each row of the definition
};

/// One setting of a sweep: its cell, and where it lies on the axes.
struct SweepPointRecord {
    std::string cell_id;
    ParameterValues at;  ///< value by axis; an axis that does not apply is missing
};

/// Methods over the product of some axes.
struct SweepRecord {
    nlohmann::json definition;  ///< reports/<id>.json, as read; null when the command line asked
    std::string title;
    std::vector<std::string> axes;
    std::vector<SweepPointRecord> points;
    std::optional<double> budget_ms;  ///< of the AO pass with its filter
    double timing_confidence = 0.95;  ///< of the medians' intervals
    std::vector<std::string> notes;   ///< what was left out, and why
};

/// One measured part of a claim: a number with the interval that 95 % of repetitions would give, and the
/// range it is claimed to lie in.
struct ClaimFinding {
    std::string about;  ///< what it shows; may be empty
    std::string what;   ///< "AO pass: Alchemy AO (...) over HBAO (...)"
    std::string unit;
    int decimals = 2;  ///< to print it with
    std::optional<double> value, low, high;
    std::optional<double> claimed_low, claimed_high;
    std::string outcome;  ///< as ClaimRecord::verdict
};

/// A statement of a source, and whether it holds here.
struct ClaimRecord {
    static constexpr const char* kHolds = "holds";
    static constexpr const char* kFails = "does not hold";
    static constexpr const char* kCannotTell = "cannot be told here";
    std::string id;       ///< "H01"
    std::string source;   ///< author, title, year
    std::string place;    ///< where the source says it
    std::string claim;    ///< in our own words
    std::string verdict;  ///< one of the three above
    std::string reason;   ///< why it cannot be told
    std::string own;      ///< what the source's own printed numbers say; empty where they agree
    std::string note;     ///< how what is measured here differs from what the source looked at
    std::vector<ClaimFinding> findings;
    std::vector<std::string> cell_ids;  ///< what was measured for it
};

/// What a run did, and what it found done.
struct WorkRecord {
    std::uint64_t rays = 0;          ///< traced for truths
    std::uint64_t gbuffers = 0;      ///< drawn
    std::uint64_t passes = 0;        ///< of methods, filters and lighting, drawn
    std::uint64_t compilations = 0;  ///< of their programs
    std::size_t cells_measured = 0;
    std::size_t cells_reused = 0;  ///< measured by an earlier run
};

struct Results {
    static constexpr int kSchemaVersion = 7;
    std::string program_version;
    std::string created_utc;  ///< 2026-11-22T02:11:47Z
    std::string command;      ///< that makes it again
    std::string cpu;
    int threads = 0;
    std::string gl_renderer;
    std::string gl_version;
    std::uint64_t seed = 0;
    double mask_threshold = 0.1;  ///< of missing and false occlusion, in visibility
    WorkRecord work;
    double total_seconds = 0;
    double peak_memory_mib = 0;
    std::vector<ViewRecord> views;
    std::vector<CellRecord> cells;
    std::vector<RankingRecord> rankings;     ///< one for each view, then those over views
    std::optional<BaselineRecord> baseline;  ///< empty where none was asked for
    std::vector<TableRecord> tables;
    std::vector<SweepRecord> sweeps;
    std::vector<ClaimRecord> claims;
    std::vector<std::string> warnings;
};

/// Single records, for stores of them. Readers throw file_error as results_from_json() does.
nlohmann::json to_json(const ViewRecord& view);
nlohmann::json to_json(const CellRecord& cell);
ViewRecord view_record_from_json(const nlohmann::json& json, const std::string& where);
CellRecord cell_record_from_json(const nlohmann::json& json, const std::string& where);

nlohmann::json to_json(const Results& results);
nlohmann::json to_json(const ErrorAnalysis& analysis);
/// Throws file_error for another schema version or a missing member. `where` names the file in errors.
Results results_from_json(const nlohmann::json& json, const std::string& where);

/// folder/results.json.
void write_results(const Results& results, const std::filesystem::path& folder);
/// `path` is that file, or its folder.
Results read_results(const std::filesystem::path& path);

}  // namespace aoscore
