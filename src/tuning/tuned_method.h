#pragma once

#include "tuning/objective.h"
#include "tuning/search.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// What the settings are for views that they were not tuned on: each group of views is left out once, and
/// measured with settings tuned on the others.
struct HeldOut {
    std::string groups;  ///< "view" or "scene"
    double loss = 0;     ///< over the views that were left out
    /// The loss of tuned settings less that of the preset, the mean over the groups, and its 95 % interval by
    /// Student's distribution.
    double gain = 0, low = 0, high = 0;

    enum class Verdict { closer, tie, farther };
    Verdict verdict() const;
};

/// The worth of one parameter.
struct ParameterWorth {
    std::string parameter;
    double published = 0, tuned = 0;  ///< values at the reference radius
    double alone = 0;                 ///< loss with this one tuned and the others published
    double without = 0;               ///< loss with this one published and the others tuned
};

/// What settings may cost at most; empty: as much as they like.
struct Budget {
    std::optional<double> fetches;  ///< a pixel
    std::optional<double> ms;       ///< of AO passes and filter, see Objective::milliseconds()
    bool is_limited() const { return fetches || ms; }
};
/// The budget in words: "at most 24 fetches and 8 ms"; empty without one.
std::string budget_text(const Budget& budget);

/// A method's settings of least loss within a budget.
struct TunedMethod {
    Budget budget;
    Settings settings;
    double published_loss = 0, published_fetches = 0;
    double fitted_loss = 0, fetches = 0;     ///< on the views that it was tuned on
    std::optional<double> published_ms, ms;  ///< empty where the budget does not limit them
    std::vector<double> published_by_view, fitted_by_view;
    std::vector<HeldOut> held_out;  ///< empty where one view is all there is
    std::vector<ParameterWorth> worth;
};

/// Tunes the subject over all views and measures what that is worth on views left out. The same settings are
/// measured once for all of it.
TunedMethod tuned(const TuningSubject& subject, Objective& objective,
                  const std::vector<std::unique_ptr<TuningView>>& views, const Budget& budget,
                  const SearchEffort& effort);

}  // namespace aoscore
