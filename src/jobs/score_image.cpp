#include "jobs/score_image.h"

#include "core/error.h"
#include "jobs/contest/truth_image.h"
#include "jobs/truth_record.h"
#include "jobs/truth_signals.h"
#include "metrics/analysis/analysis.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/intervals/truth_noise.h"
#include "metrics/measures/noise.h"
#include "metrics/signal_metric.h"
#include "results/record_json.h"
#include "results/results_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace aoscore {
namespace {

/// Compares an image with one query of a truth, and with the truth's halves where it has them.
class Comparison {
  public:
    Comparison(const Truth& truth, std::size_t query, const ImageF& image, const Mask& valid)
        : input_{truth.visibility[query], image, valid} {
        // A truth of another program may not say how sure it is.
        if (!truth.standard_error[query].empty()) input_.standard_error = &truth.standard_error[query];
        input_.maps = &maps_[0];
        if (truth.halves.empty()) return;
        halves_.emplace(truth.halves[query][0], truth.halves[query][1], &maps_[1], &maps_[2], nullptr,
                        &maps_[3], truth.samples);
        input_.halves = &*halves_;
    }
    /// Compares with the first query; `valid` must be the mask that the side was made for.
    Comparison(const Truth& truth, const TruthSide& side, const ImageF& image, const Mask& valid)
        : Comparison(truth, 0, image, valid) {
        input_.prepared_truth = side.undivided();
        if (halves_) halves_->prepared = side.halves();
    }
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;

    const MetricInput& input() const { return input_; }

  private:
    std::array<MapSums, 4> maps_;  ///< against the truth, its halves, and the truth with its noise
    std::optional<TruthHalves> halves_;
    MetricInput input_;
};

/// Measures those of `ids` that are wanted, or of all metrics when it is empty.
MetricMap measured(const MetricInput& input, const ScoreSettings& settings,
                   const std::vector<std::string>& ids = {}) {
    if (settings.untold) return evaluate(input, ids);
    return evaluate(input, told_metrics(mean_noise_variance(input).value_or(0), ids));
}

/// The noise as analyse() finds it, for the metrics that evaluate() has measured.
std::map<std::string, double> noise_of(const MetricInput& input) {
    if (input.halves == nullptr) return {};
    return truth_noise(block_errors(input), block_errors(against_half(input, 0)),
                       block_errors(against_half(input, 1)), *input.halves);
}

MetricMap raw_metrics(const Truth& truth, const Ground& ground, const TruthSide& side, const ImageF& raw,
                      const ScoreSettings& settings) {
    std::size_t nonfinite = 0;
    const Mask valid = finite_pixels(truth.visibility[0], raw, ground.contract.valid, nonfinite);
    // The side was made for all valid pixels.
    if (nonfinite > 0)
        return measured(Comparison(truth, 0, raw, valid).input(), settings, unranked_metrics());
    return measured(Comparison(truth, side, raw, valid).input(), settings, unranked_metrics());
}

}  // namespace

std::string Score::error() const {
    return nonfinite > 0 ? fmt::format("{} pixels are NaN or infinite", nonfinite) : "";
}

Score score_image(const Truth& truth, const Ground& ground, const TruthSide& side, const MethodOutput& image,
                  const ScoreSettings& settings) {
    require_comparable(ground);
    Score score;
    const Mask valid =
        finite_pixels(truth.visibility[0], image.visibility, ground.contract.valid, score.nonfinite);
    if (score.nonfinite > 0) return score;
    const Comparison ranked(truth, side, image.visibility, valid);
    score.ranked = measured(ranked.input(), settings);
    score.analysis =
        analyse(ranked.input(), ground.facts, settings.mask_threshold, settings.seed, &side.divisions());
    if (settings.filtered) score.raw = raw_metrics(truth, ground, side, image.raw, settings);
    for (const auto& [id, of_signal] : image.signals) {
        const TruthSignal known = truth_signal(truth, id);
        score.signals[id] =
            evaluate_signal(id, {known.image, of_signal, ground.contract.valid, *known.standard_error_rad});
    }
    return score;
}

OwnScore score_own(const Truth& truth, const TruthQuery& query, const Ground& ground, const ImageF& image) {
    const std::size_t q = query_index(truth, query);
    std::size_t nonfinite = 0;
    const Mask valid = finite_pixels(truth.visibility[q], image, ground.contract.valid, nonfinite);
    const Comparison comparison(truth, q, image, valid);
    OwnScore score{query_record(truth, q, ground.contract.valid), {}, {}};
    score.metrics = evaluate(comparison.input(), unranked_metrics());
    score.truth_noise = noise_of(comparison.input());
    return score;
}

nlohmann::json to_json(const Score& score) {
    return record_json::checked_json(score, "score");
}

Score score_from_json(const nlohmann::json& json, const std::string& where) {
    return record_json::record_from_json<Score>(json, where);
}

nlohmann::json to_json(const OwnScore& score) {
    return record_json::checked_json(score, "own score");
}

OwnScore own_score_from_json(const nlohmann::json& json, const std::string& where) {
    return record_json::record_from_json<OwnScore>(json, where);
}

}  // namespace aoscore
