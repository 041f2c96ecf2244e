#include "tuning/tuned_method.h"

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace aoscore {
namespace {

using ViewNumbers = std::vector<std::size_t>;

/// Tunes on some of the views.
class Tuner {
  public:
    Tuner(const TuningSubject& subject, Objective& objective, const Budget& budget,
          const SearchEffort& effort)
        : subject_(subject), objective_(objective), effort_(effort) {
        if (!budget.is_limited()) return;
        excess_ = [this, budget](const Settings& settings) {
            double part = 0;
            if (budget.fetches) part = objective_.fetches(settings) / *budget.fetches;
            if (budget.ms) part = std::max(part, objective_.milliseconds(settings) / *budget.ms);
            return part - 1;
        };
    }

    Settings best_on(const ViewNumbers& views) {
        const SearchGoal goal{[&](const Settings& settings) { return objective_.loss_over(settings, views); },
                              excess_};
        return best_settings(subject_.axes, goal, objective_.published(), effort_);
    }

  private:
    const TuningSubject& subject_;
    Objective& objective_;
    std::function<double(const Settings&)> excess_;
    SearchEffort effort_;
};

ViewNumbers all_numbers(std::size_t count) {
    ViewNumbers numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

ViewNumbers others(const ViewNumbers& group, std::size_t count) {
    ViewNumbers rest = all_numbers(count);
    std::erase_if(rest, [&](std::size_t v) { return std::ranges::find(group, v) != group.end(); });
    return rest;
}

std::vector<ViewNumbers> by_view(std::size_t count) {
    std::vector<ViewNumbers> groups;
    for (std::size_t v = 0; v < count; ++v) groups.push_back({v});
    return groups;
}

std::vector<ViewNumbers> by_scene(const std::vector<std::unique_ptr<TuningView>>& views) {
    std::vector<std::string> names;
    std::vector<ViewNumbers> groups;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto found = std::ranges::find(names, views[v]->scene);
        const auto place = static_cast<std::size_t>(found - names.begin());
        if (found == names.end()) {
            names.push_back(views[v]->scene);
            groups.emplace_back();
        }
        groups[place].push_back(v);
    }
    return groups;
}

/// Fills in the mean of the differences with its interval. There are at least two.
void summarise(const std::vector<double>& differences, HeldOut& held_out) {
    const double n = static_cast<double>(differences.size());
    const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / n;
    double squares = 0;
    for (const double d : differences) squares += (d - mean) * (d - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    const double reach = boost::math::quantile(boost::math::students_t(n - 1), 0.975) * error;
    held_out.gain = mean;
    held_out.low = mean - reach;
    held_out.high = mean + reach;
}

HeldOut left_out(const std::string& name, const std::vector<ViewNumbers>& groups, std::size_t views,
                 const Metric& metric, Tuner& tuner, Objective& objective) {
    HeldOut result{.groups = name};
    std::vector<double> losses(views), differences;
    for (const ViewNumbers& group : groups) {
        const Settings settings = tuner.best_on(others(group, views));
        for (const std::size_t v : group) losses[v] = objective.loss(settings, v);
        differences.push_back(objective.loss_over(settings, group) -
                              objective.loss_over(objective.published(), group));
    }
    result.loss = metric.over_views(losses);
    summarise(differences, result);
    return result;
}

std::vector<ParameterWorth> worth_of(const TuningSubject& subject, Objective& objective,
                                     const Settings& settings, const ViewNumbers& all) {
    const Settings published = objective.published();
    std::vector<ParameterWorth> rows;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        Settings alone = published, without = settings;
        alone[i] = settings[i];
        without[i] = published[i];
        rows.push_back({subject.axes[i].parameter, published[i], settings[i], objective.loss_over(alone, all),
                        objective.loss_over(without, all)});
    }
    return rows;
}

}  // namespace

std::string budget_text(const Budget& budget) {
    if (!budget.is_limited()) return "";
    std::string text = "at most ";
    if (budget.fetches) text += fmt::format("{:g} fetches", *budget.fetches);
    if (budget.fetches && budget.ms) text += " and ";
    if (budget.ms) text += fmt::format("{:g} ms", *budget.ms);
    return text;
}

HeldOut::Verdict HeldOut::verdict() const {
    if (high < 0) return Verdict::closer;
    return low > 0 ? Verdict::farther : Verdict::tie;
}

TunedMethod tuned(const TuningSubject& subject, Objective& objective,
                  const std::vector<std::unique_ptr<TuningView>>& views, const Budget& budget,
                  const SearchEffort& effort) {
    const ViewNumbers all = all_numbers(views.size());
    const Settings published = objective.published();
    Tuner tuner(subject, objective, budget, effort);
    TunedMethod result;
    result.budget = budget;
    result.settings = tuner.best_on(all);
    result.published_loss = objective.loss_over(published, all);
    result.published_fetches = objective.fetches(published);
    result.fitted_loss = objective.loss_over(result.settings, all);
    result.fetches = objective.fetches(result.settings);
    if (budget.ms) {
        result.published_ms = objective.milliseconds(published);
        result.ms = objective.milliseconds(result.settings);
    }
    for (const std::size_t v : all) {
        result.published_by_view.push_back(objective.loss(published, v));
        result.fitted_by_view.push_back(objective.loss(result.settings, v));
    }
    result.worth = worth_of(subject, objective, result.settings, all);
    const Metric& decides = metric(subject.metric);
    if (views.size() > 1)
        result.held_out.push_back(
            left_out("view", by_view(views.size()), views.size(), decides, tuner, objective));
    const std::vector<ViewNumbers> scenes = by_scene(views);
    if (scenes.size() > 1 && scenes.size() < views.size())
        result.held_out.push_back(left_out("scene", scenes, views.size(), decides, tuner, objective));
    return result;
}

}  // namespace aoscore
