#include "page/sections/sweep_chart.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;
using Rows = std::vector<const SweepRow*>;

json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? json(*value) : json();
}

/// The method with its values on axes of words, such as a preset: between these there is nothing.
std::string method_and_words(const SweepRow& row) {
    std::string text = row.cell->method_label;
    for (const auto& [axis, value] : row.point->at) {
        if (axis != "method" && value.is_word()) text += ", " + value.word();
    }
    return text;
}

/// The rows that a chart joins by a line: those that differ by numbers, or, where these are too many curves,
/// all of a method.
std::map<std::string, Rows> curves_of(const Rows& rows) {
    constexpr std::size_t kMostCurves = 8;
    std::map<std::string, Rows> by_method, by_words;
    for (const SweepRow* row : rows) {
        if (!row->cost_ms || !row->error) continue;
        by_method[row->cell->method_label].push_back(row);
        by_words[method_and_words(*row)].push_back(row);
    }
    return by_words.size() <= kMostCurves ? by_words : by_method;
}

}  // namespace

json sweep_chart(const Rows& rows, std::optional<double> budget_ms) {
    json curves = json::array();
    for (const auto& [label, points] : curves_of(rows)) {
        json list = json::array();
        for (const SweepRow* row : points) {
            list.push_back({{"at", point_text(*row->point)},
                            {"ms", number(row->cost_ms)},
                            {"ms_low", number(row->cost_low_ms)},
                            {"ms_high", number(row->cost_high_ms)},
                            {"relative", number(row->relative_cost)},
                            {"fetches", number(row->fetches)},
                            {"error", number(row->error)},
                            {"noisy", number(row->noisy_error)},
                            {"fitted", number(row->fitted_error)},
                            {"front", row->on_front}});
        }
        const bool bound = points.front()->cell->role == kBoundRole;
        curves.push_back({{"label", label}, {"bound", bound}, {"points", std::move(list)}});
    }
    return {{"curves", std::move(curves)}, {"budget_ms", number(budget_ms)}};
}

}  // namespace aoscore
