#include "tuning/search.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <optional>

namespace aoscore {
namespace {

/// Above every loss, so that settings beyond the budget never win, and less of it the nearer they are.
constexpr double kBeyondBudget = 1e3;

/// One search: what it tries, and the best of that.
class Search {
  public:
    Search(const std::vector<SearchAxis>& axes, const SearchGoal& goal) : axes_(axes), goal_(goal) {}

    double cost(const Settings& settings) {
        const double excess = goal_.excess ? goal_.excess(settings) : 0;
        least_excess_ = std::min(least_excess_, excess);
        if (excess > 0) return kBeyondBudget * (1 + excess);
        const double loss = goal_.loss(settings);
        if (loss < best_loss_) {
            best_loss_ = loss;
            best_ = settings;
        }
        return loss;
    }

    void by_nlopt(nlopt_algorithm algorithm, const Settings& begin, int most);
    void by_single_values(const Settings& begin);

    const std::optional<Settings>& best() const { return best_; }
    double least_excess() const { return least_excess_; }

  private:
    static double called(unsigned count, const double* positions, double* gradient, void* search);

    const std::vector<SearchAxis>& axes_;
    const SearchGoal& goal_;
    double best_loss_ = std::numeric_limits<double>::infinity();
    double least_excess_ = std::numeric_limits<double>::infinity();
    std::optional<Settings> best_;
    nlopt_opt running_ = nullptr;
    std::exception_ptr thrown_;
};

// NLopt is written in C: no exception may pass through it.
double Search::called(unsigned count, const double* positions, double*, void* data) {
    Search& search = *static_cast<Search*>(data);
    Settings settings(count);
    for (unsigned i = 0; i < count; ++i) settings[i] = search.axes_[i].value(positions[i]);
    try {
        return search.cost(settings);
    } catch (...) {
        search.thrown_ = std::current_exception();
        nlopt_force_stop(search.running_);
        return kBeyondBudget;
    }
}

void Search::by_nlopt(nlopt_algorithm algorithm, const Settings& begin, int most) {
    if (most < 1) return;
    const auto count = static_cast<unsigned>(axes_.size());
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> opt(nlopt_create(algorithm, count),
                                                                     nlopt_destroy);
    running_ = opt.get();
    nlopt_set_lower_bounds1(running_, 0);
    nlopt_set_upper_bounds1(running_, 1);
    nlopt_set_min_objective(running_, called, this);
    nlopt_set_maxeval(running_, most);
    nlopt_set_initial_step1(running_, 0.1);
    nlopt_set_xtol_abs1(running_, 1e-3);
    std::vector<double> positions(count);
    for (unsigned i = 0; i < count; ++i) positions[i] = axes_[i].position(begin[i]);
    double least = 0;
    nlopt_optimize(running_, positions.data(), &least);
    if (thrown_) std::rethrow_exception(thrown_);
}

// A global search of few settings leaves values where they do harm.
void Search::by_single_values(const Settings& begin) {
    for (bool helped = best_.has_value(); helped;) {
        const double before = best_loss_;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            std::vector<double> values{begin[i]};
            if (axes_[i].whole) values.insert(values.end(), {(*best_)[i] - 1, (*best_)[i] + 1});
            for (const double value : values) {
                Settings next = *best_;
                next[i] = value;
                if (value < axes_[i].low || value > axes_[i].high || next == *best_) continue;
                // A value that changes nothing goes back as well.
                if (cost(next) <= best_loss_ && value == begin[i]) best_ = next;
            }
        }
        helped = best_loss_ < before;
    }
}

}  // namespace

Settings best_settings(const std::vector<SearchAxis>& axes, const SearchGoal& goal, const Settings& begin,
                       const SearchEffort& effort) {
    Search search(axes, goal);
    search.cost(begin);
    search.by_nlopt(NLOPT_GN_DIRECT_L, begin, effort.global);
    search.by_single_values(begin);
    search.by_nlopt(NLOPT_LN_SBPLX, search.best().value_or(begin), effort.local);
    search.by_single_values(begin);
    if (!search.best())
        throw usage_error(
            fmt::format("no settings that were tried keep the budget: the cheapest go {:.0f} % beyond it",
                        100 * search.least_excess()),
            "--max-fetches, --budget-ms", "a larger budget");
    return *search.best();
}

}  // namespace aoscore
