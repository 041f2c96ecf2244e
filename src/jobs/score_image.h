#pragma once

#include "jobs/ground.h"
#include "jobs/truth_side.h"
#include "reference/truth.h"
#include "results/record_of.h"
#include "results/results.h"
#include "screen/screen.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace aoscore {

/// The scores of an image against the ranking's truth.
struct Score {
    std::size_t nonfinite = 0;  ///< valid pixels that are NaN or infinite: then there are no numbers
    MetricMap ranked;
    std::optional<ErrorAnalysis> analysis;
    MetricMap raw;                             ///< metrics before the filter; empty without one
    std::map<std::string, MetricMap> signals;  ///< metrics of the image's signals beside visibility, by id
    std::optional<double> reported_ms;         ///< the cost that the contestant reports of itself
    std::string reported_on;                   ///< what that was measured on

    /// Says why there are no numbers; empty where there are.
    std::string error() const;
};

template <class Visit, RecordOf<Score> Record>
void visit_members(Visit& visit, Record& score) {
    visit("nonfinite", score.nonfinite);
    visit("ranked", score.ranked);
    visit("analysis", score.analysis);
    visit("raw", score.raw);
    visit("signals", score.signals);
    visit("reported_ms", score.reported_ms);
    visit("reported_on", score.reported_on);
}

/// Settings of a score.
struct ScoreSettings {
    bool filtered = false;        ///< whether the image is: it is then scored before its filter, too
    double mask_threshold = 0.1;  ///< for missing and false occlusion, in visibility
    std::uint64_t seed = 1;       ///< seed of the resampling
    /// Includes metrics that the truth's noise hides (told_metrics()): their values are far off, but say how
    /// many more rays they need.
    bool untold = true;
};

/// Computes every metric and the analysis against the truth's first query; `side` belongs to this truth and
/// ground. Throws gate_failed where no pixel is valid, and internal_error where ray tracer and rasteriser
/// disagree.
Score score_image(const Truth& truth, const Ground& ground, const TruthSide& side, const MethodOutput& image,
                  const ScoreSettings& settings);

/// The scores of an image against its method's own truth.
struct OwnScore {
    TruthRecord truth;
    MetricMap metrics;
    std::map<std::string, double> truth_noise;  ///< as ErrorAnalysis::truth_noise
};

template <class Visit, RecordOf<OwnScore> Record>
void visit_members(Visit& visit, Record& score) {
    visit("truth", score.truth);
    visit("metrics", score.metrics);
    visit("truth_noise", score.truth_noise);
}

/// Computes the metrics that are stored for own truths, against one query of the truth.
OwnScore score_own(const Truth& truth, const TruthQuery& query, const Ground& ground, const ImageF& image);

nlohmann::json to_json(const Score& score);
/// Reads a score. Throws file_error for another form.
Score score_from_json(const nlohmann::json& json, const std::string& where);
nlohmann::json to_json(const OwnScore& score);
OwnScore own_score_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
