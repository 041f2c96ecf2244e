#pragma once

#include "metrics/intervals/bootstrap.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// What one change of a cell's settings would buy, measured on the same view against the same truth.
struct StepRecord {
    static constexpr const char* kCloser = "closer";
    static constexpr const char* kTie = "tie";
    static constexpr const char* kFarther = "farther";
    static constexpr const char* kFailed = "failed";

    std::string id;               ///< the kind of step: "more-taps"
    std::string what;             ///< what is changed: "slices 3 to 6"
    std::optional<double> error;  ///< AdviceRecord::metric after the step; empty where it failed
    /// The interval of its error less the cell's, paired; all of the cell's steps hold together with 95 %
    /// confidence.
    std::optional<Interval> change;
    std::string verdict = kFailed;  ///< one of the four above, by that interval
    /// How much longer a frame takes, milliseconds (below 0: how much shorter), of processor time where it
    /// was taken, as the cell's fixed pass measures time; and an interval by those of both medians. Empty
    /// where nothing could be timed: `reason` says why.
    std::optional<double> ms;
    std::optional<Interval> ms_interval;
    std::optional<double> fetches;  ///< how many more fetches a pixel the AO passes take
    std::string reason;             ///< why it failed, or why its cost is not known

    /// Error that it takes off; below 0 where it adds some.
    std::optional<double> bought(double before) const {
        return error ? std::optional(before - *error) : std::nullopt;
    }
    /// Whether it takes more time: surely, where the runs were enough to tell.
    bool costs() const { return ms_interval ? ms_interval->low > 0 : ms && *ms > 0; }
};

/// A step that a cell does not have, and why.
struct SkippedStep {
    std::string id, reason;
};

/// What the next step from one cell would buy: the best buy first (see judge_advice()).
struct AdviceRecord {
    std::string cell_id;
    std::string metric;                   ///< the ranking's
    double error = 0;                     ///< its value for the cell
    std::optional<double> ms;             ///< of the cell's AO pass with its filter
    std::optional<double> fixed_pass_ms;  ///< of the fixed pass, timed with it
    std::optional<double> fetches;        ///< a pixel, of its AO passes
    std::vector<StepRecord> steps;
    std::vector<SkippedStep> skipped;
};

}  // namespace aoscore
