#include "report/closeness.h"
#include "report/number_text.h"
#include "report/section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace aoscore {
namespace {

/// The cells of one view and preset: what can be compared fairly.
struct Comparison {
    std::string view_key, preset;
    std::vector<const CellRecord*> cells;

    std::string name() const { return fmt::format("{} ({})", view_key, preset); }
};

struct Outcome {
    std::string sentence;
    std::string winner;  ///< label; empty without one
    bool tie = false;
};

std::vector<Comparison> comparisons(const Results& results) {
    std::vector<Comparison> list;
    for (const CellRecord& cell : results.cells) {
        const auto found = std::find_if(list.begin(), list.end(), [&](const Comparison& c) {
            return c.view_key == cell.view_key && c.preset == cell.preset;
        });
        if (found != list.end()) {
            found->cells.push_back(&cell);
        } else {
            list.push_back({cell.view_key, cell.preset, {&cell}});
        }
    }
    return list;
}

std::string cost_clause(const CellRecord& best, const CellRecord& second) {
    std::vector<std::string> costs;
    if (const auto times = ratio(cost_ms(best), cost_ms(second))) {
        costs.push_back(fmt::format("{} times its milliseconds", fixed_text(times, 2)));
    }
    if (best.fetches_per_pixel && second.fetches_per_pixel) {
        costs.push_back(fmt::format("{} against {} fetches a pixel", fixed_text(best.fetches_per_pixel, 1),
                                    fixed_text(second.fetches_per_pixel, 1)));
    }
    if (costs.empty()) return "";
    return ", at " + costs.front() + (costs.size() > 1 ? " and " + costs.back() : "");
}

Outcome judge(const PageSource& source, const Comparison& comparison) {
    const std::string metric = ranking_metric(comparison.cells);
    const std::string metric_label = metric == "rmse_debiased" ? "debiased RMSE" : "RMSE";
    std::vector<const CellRecord*> ranked;
    std::copy_if(comparison.cells.begin(), comparison.cells.end(), std::back_inserter(ranked),
                 [&](const CellRecord* cell) { return ranked_value(*cell, metric).has_value(); });
    std::stable_sort(ranked.begin(), ranked.end(), [&](const CellRecord* a, const CellRecord* b) {
        return *ranked_value(*a, metric) < *ranked_value(*b, metric);
    });
    if (ranked.empty())
        return {fmt::format("On {} no method could be scored.", comparison.name()), "", false};

    const CellRecord& best = *ranked.front();
    const double best_error = *ranked_value(best, metric);
    if (ranked.size() == 1) {
        return {fmt::format("On {} {} alone was scored: {} {}.", comparison.name(), shown_name(best),
                            metric_label, fixed_text(best_error, 4)),
                shown_name(best), false};
    }
    const CellRecord& second = *ranked[1];
    const double second_error = *ranked_value(second, metric);
    if (are_tied(source.results, best, second)) {
        return {
            fmt::format("On {} {} and {} tie: {} {} and {}, a difference that resampled parts of the picture "
                        "turn round{}.",
                        comparison.name(), shown_name(best), shown_name(second), metric_label,
                        fixed_text(best_error, 4), fixed_text(second_error, 4), cost_clause(best, second)),
            "", true};
    }
    std::string lead;
    if (const auto part = ratio(second_error - best_error, second_error)) {
        lead = fmt::format(", {} % below {}", percent_text(part, 0), shown_name(second));
    }
    return {
        fmt::format("On {} {} comes closest to the truth: {} {}{}{}.", comparison.name(), shown_name(best),
                    metric_label, fixed_text(best_error, 4), lead, cost_clause(best, second)),
        shown_name(best), false};
}

std::string lead_sentence(const std::vector<Outcome>& outcomes) {
    std::map<std::string, int> wins;
    int ties = 0;
    for (const Outcome& outcome : outcomes) {
        if (!outcome.winner.empty()) ++wins[outcome.winner];
        if (outcome.tie) ++ties;
    }
    const std::size_t count = outcomes.size();
    if (wins.empty()) return fmt::format("No method is ahead in any of the {} comparisons.", count);
    const auto most = std::max_element(wins.begin(), wins.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (static_cast<std::size_t>(most->second) == count) {
        return fmt::format("{} comes closest to the ray-traced truth in all {} comparisons.", most->first,
                           count);
    }
    std::string text = "No method comes closest to the ray-traced truth everywhere: ";
    bool first = true;
    for (const auto& [label, won] : wins) {
        text += fmt::format("{}{} leads in {}", first ? "" : ", ", label, won);
        first = false;
    }
    if (ties > 0) text += fmt::format(", {} {}", ties, ties == 1 ? "is a tie" : "are ties");
    return text + fmt::format(", of {} comparisons.", count);
}

/// The ranking over views; null where there is none, or one for each of several presets.
const RankingRecord* ranking_over_views(const Results& results) {
    const RankingRecord* found = nullptr;
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() < 2) continue;
        if (found != nullptr) return nullptr;
        found = &ranking;
    }
    return found;
}

std::string overall_sentence(const RankingRecord& ranking) {
    const PlaceRecord& best = ranking.places.front();
    const std::string mean =
        fmt::format("mean {} {}", ranking.metric == "rmse_debiased" ? "debiased RMSE" : "RMSE",
                    fixed_text(best.value, 4));
    const std::string where = fmt::format("Over {} views", ranking.view_keys.size());
    if (best.ties.empty()) {
        return fmt::format("{} {} comes closest to the ray-traced truth: {}.", where, best.method_label,
                           mean);
    }
    std::vector<std::string> others;
    for (const std::size_t other : best.ties) others.push_back(ranking.places.at(other).method_label);
    return fmt::format(
        "{} {} comes closest to the ray-traced truth ({}), but not surely: {} {} tied with it.", where,
        best.method_label, mean, fmt::join(others, ", "), others.size() == 1 ? "is" : "are");
}

}  // namespace

nlohmann::json section::verdict(const PageSource& source) {
    std::vector<Outcome> outcomes;
    for (const Comparison& comparison : comparisons(source.results))
        outcomes.push_back(judge(source, comparison));
    nlohmann::json model;
    model["details"] = nlohmann::json::array();
    if (outcomes.empty()) {
        model["lead"] = "Nothing was scored.";
    } else if (outcomes.size() == 1) {
        model["lead"] = outcomes.front().sentence;
    } else {
        const RankingRecord* overall = ranking_over_views(source.results);
        model["lead"] = overall != nullptr ? overall_sentence(*overall) : lead_sentence(outcomes);
        for (const Outcome& outcome : outcomes) model["details"].push_back(outcome.sentence);
    }
    const auto failed = std::count_if(source.results.cells.begin(), source.results.cells.end(),
                                      [](const CellRecord& cell) { return !cell.error.empty(); });
    model["failed"] = failed > 0;
    model["failed_count"] = failed == 1 ? std::string("1 cell failed and is not ranked")
                                        : fmt::format("{} cells failed and are not ranked", failed);
    return model;
}

}  // namespace aoscore
