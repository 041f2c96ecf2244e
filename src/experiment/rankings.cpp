#include "experiment/rankings.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace aoscore {
namespace {

/// One method with its cells, one on each view of a ranking.
using Entry = std::vector<const CellRecord*>;

std::vector<const BlockErrors*> blocks_of(const Entry& entry) {
    std::vector<const BlockErrors*> blocks;
    for (const CellRecord* cell : entry) blocks.push_back(&cell->analysis->blocks);
    return blocks;
}

bool has(const CellRecord& cell, const std::string& metric) {
    const auto found = cell.ranked.find(metric);
    return found != cell.ranked.end() && found->second.value.has_value();
}

double mean_of(const Entry& entry, const std::string& metric) {
    double sum = 0;
    for (const CellRecord* cell : entry) sum += *cell->ranked.at(metric).value;
    return sum / static_cast<double>(entry.size());
}

/// Every measure that all cells have; of one view as its analysis says.
std::map<std::string, MeasureRecord> measures_of(const Entry& entry, std::uint64_t seed) {
    std::map<std::string, MeasureRecord> measures;
    for (const auto& [id, metric] : entry.front()->ranked) {
        if (std::ranges::all_of(entry, [&](const CellRecord* cell) { return has(*cell, id); }))
            measures[id].value = mean_of(entry, id);
    }
    const auto area_of = [&](MaskSummary ErrorAnalysis::*mask) {
        double sum = 0;
        for (const CellRecord* cell : entry) sum += (*cell->analysis.*mask).area;
        return sum / static_cast<double>(entry.size());
    };
    measures[kMissingArea].value = area_of(&ErrorAnalysis::missing);
    measures[kFalseArea].value = area_of(&ErrorAnalysis::false_occlusion);
    const std::map<std::string, Interval> intervals =
        entry.size() == 1 ? entry.front()->analysis->intervals : confidence_intervals(blocks_of(entry), seed);
    for (auto& [id, measure] : measures) {
        if (const auto found = intervals.find(id); found != intervals.end()) measure.interval = found->second;
    }
    return measures;
}

PlaceRecord place_of(const Entry& entry, const std::string& metric, std::uint64_t seed) {
    PlaceRecord place;
    place.method = entry.front()->method;
    place.method_label = shown_name(*entry.front());
    place.filter = entry.front()->filter;
    for (const CellRecord* cell : entry) place.cell_ids.push_back(cell->id);
    place.value = mean_of(entry, metric);
    place.measures = measures_of(entry, seed);
    return place;
}

void find_ties(std::vector<PlaceRecord>& places, const std::vector<std::vector<double>>& values) {
    for (std::size_t a = 0; a < places.size(); ++a) {
        places[a].interval =
            confidence_interval(values[a]).value_or(Interval{places[a].value, places[a].value});
        if (a > 0) places[a].behind_best = confidence_interval(values[a], values[0]).value_or(Interval{});
        for (std::size_t b = 0; b < places.size(); ++b) {
            if (a == b) continue;
            const Interval difference = confidence_interval(values[b], values[a]).value_or(Interval{});
            if (difference.high < 0) ++places[a].rank;
            if (difference.holds_zero()) places[a].ties.push_back(b);
        }
    }
}

RankingRecord ranking_of(std::vector<Entry> entries, const std::string& preset, std::uint64_t seed) {
    RankingRecord ranking;
    ranking.preset = preset;
    for (const CellRecord* cell : entries.front()) ranking.view_keys.push_back(cell->view_key);
    const bool debiased = std::ranges::all_of(entries, [](const Entry& entry) {
        return std::ranges::all_of(entry, [](const CellRecord* cell) { return has(*cell, "rmse_debiased"); });
    });
    ranking.metric = debiased ? "rmse_debiased" : "rmse";
    std::ranges::stable_sort(entries, {}, [&](const Entry& entry) { return mean_of(entry, ranking.metric); });
    std::vector<std::vector<double>> values;
    for (const Entry& entry : entries) {
        ranking.places.push_back(place_of(entry, ranking.metric, seed));
        values.push_back(resampled(ranking.metric, blocks_of(entry), seed));
    }
    find_ties(ranking.places, values);
    return ranking;
}

/// Keeps the order in which keys came first.
template <class Key, class Value>
class OrderedGroups {
  public:
    Value& operator[](const Key& key) {
        const auto found = std::ranges::find(groups_, key, &std::pair<Key, Value>::first);
        if (found != groups_.end()) return found->second;
        return groups_.emplace_back(key, Value{}).second;
    }
    auto begin() const { return groups_.begin(); }
    auto end() const { return groups_.end(); }
    std::size_t size() const { return groups_.size(); }

  private:
    std::vector<std::pair<Key, Value>> groups_;
};

}  // namespace

std::vector<RankingRecord> rank(const std::vector<CellRecord>& cells, std::uint64_t seed) {
    using Method = std::array<std::string, 3>;  // with its setting and filter
    OrderedGroups<std::pair<std::string, std::string>, std::vector<Entry>> by_view_and_preset;
    OrderedGroups<std::string, OrderedGroups<Method, Entry>> by_preset;
    std::map<std::string, std::set<std::string>> views_of_preset;
    for (const CellRecord& cell : cells) {
        views_of_preset[cell.preset].insert(cell.view_key);
        if (!cell.analysis || !has(cell, "rmse")) continue;
        by_view_and_preset[{cell.view_key, cell.preset}].push_back({&cell});
        by_preset[cell.preset][{cell.method, cell.setting, cell.filter}].push_back(&cell);
    }
    std::vector<RankingRecord> rankings;
    for (const auto& [key, entries] : by_view_and_preset) {
        rankings.push_back(ranking_of(entries, key.second, seed));
    }
    for (const auto& [preset, methods] : by_preset) {
        const std::size_t views = views_of_preset[preset].size();
        if (views < 2) continue;
        std::vector<Entry> everywhere;
        for (const auto& [method, entry] : methods) {
            if (entry.size() == views) everywhere.push_back(entry);
        }
        if (!everywhere.empty()) rankings.push_back(ranking_of(everywhere, preset, seed));
    }
    return rankings;
}

}  // namespace aoscore
