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

/// A method's settings of least loss within a budget of fetches.
struct TunedMethod {
    std::optional<double> most_fetches;  ///< the budget; empty: none
    Settings settings;
    double published_loss = 0, published_fetches = 0;
    double fitted_loss = 0, fetches = 0;  ///< on the views that it was tuned on
    std::vector<double> published_by_view, fitted_by_view;
    std::vector<HeldOut> held_out;  ///< empty where one view is all there is
    std::vector<ParameterWorth> worth;
};

/// Tunes the subject over all views and measures what that is worth on views left out. The same settings are
/// measured once for all of it.
TunedMethod tuned(const TuningSubject& subject, Objective& objective,
                  const std::vector<std::unique_ptr<TuningView>>& views, std::optional<double> most_fetches,
                  const SearchEffort& effort);

}  // namespace aoscore
