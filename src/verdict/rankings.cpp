#include "verdict/rankings.h"

#include "core/error.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/intervals/over_views.h"
#include "metrics/roles.h"
#include "results/comparable_views.h"
#include "results/ranked_value.h"

#include <algorithm>
#include <array>
#include <map>

namespace aoscore {
namespace {

/// One method with its settings: its cells, one on each view of a ranking.
using Entry = std::vector<const CellRecord*>;
using Views = std::vector<const ViewRecord*>;

std::vector<const BlockErrors*> blocks_of(const Entry& entry) {
    std::vector<const BlockErrors*> blocks;
    for (const CellRecord* cell : entry) blocks.push_back(&cell->analysis->blocks);
    return blocks;
}

/// The metric over the views; empty where one of the cells lacks it.
std::optional<double> value_over_views(const Entry& entry, const std::string& metric) {
    std::vector<double> values;
    for (const CellRecord* cell : entry) {
        const std::optional<double> value = value_of(cell->ranked, metric);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return measure_over_views(metric, values);
}

double area_over_views(const Entry& entry, const MaskArea& area) {
    std::vector<double> areas;
    for (const CellRecord* cell : entry) areas.push_back(area.value(*cell->analysis));
    return measure_over_views(area.id, areas);
}

/// Every measure that all cells have; for one view as its analysis gives it.
std::map<std::string, MeasureRecord> measures_of(const Entry& entry, std::uint64_t seed) {
    std::map<std::string, MeasureRecord> measures;
    for (const auto& [id, metric] : entry.front()->ranked) {
        if (const auto value = value_over_views(entry, id)) measures[id].value = *value;
    }
    for (const MaskArea& area : mask_areas())
        measures[std::string(area.id)].value = area_over_views(entry, area);
    const std::map<std::string, Interval> intervals =
        entry.size() == 1 ? entry.front()->analysis->intervals : confidence_intervals(blocks_of(entry), seed);
    for (auto& [id, measure] : measures) {
        if (const auto found = intervals.find(id); found != intervals.end()) measure.interval = found->second;
    }
    return measures;
}

PlaceRecord place_of(const Entry& entry, const Resampled& error, std::uint64_t seed) {
    PlaceRecord place;
    place.method = entry.front()->method;
    place.method_label = shown_name(*entry.front());
    place.preset = entry.front()->preset;
    place.filter = entry.front()->filter;
    for (const CellRecord* cell : entry) place.cell_ids.push_back(cell->id);
    place.value = error.value;
    place.interval = confidence_interval(error.draws);
    place.measures = measures_of(entry, seed);
    return place;
}

void add_ranks(std::vector<PlaceRecord>& places, const std::vector<std::size_t>& ranked,
               const std::vector<Resampled>& errors) {
    std::vector<Resampled> of_ranked;
    for (const std::size_t place : ranked) of_ranked.push_back(errors[place]);
    const Ranks ranks(of_ranked);
    for (std::size_t i = 0; i < ranked.size(); ++i) {
        PlaceRecord& place = places[ranked[i]];
        place.rank = ranks.range(i);
        for (const std::size_t other : ranks.ties(i)) place.ties.push_back(ranked[other]);
        if (i > 0) place.behind_first = ranks.difference(i, 0);
    }
}

RankingRecord ranking_of(std::vector<Entry> entries, const Views& views, std::uint64_t seed) {
    RankingRecord ranking;
    ranking.radius_m = views.front()->radius_m;
    for (const ViewRecord* view : views) ranking.view_keys.push_back(view->key);
    std::vector<const CellRecord*> cells;
    for (const Entry& entry : entries) cells.insert(cells.end(), entry.begin(), entry.end());
    ranking.metric = ranking_metric(cells);
    std::ranges::stable_sort(entries, {},
                             [&](const Entry& entry) { return *value_over_views(entry, ranking.metric); });
    std::vector<Resampled> errors;
    std::vector<std::size_t> ranked;
    for (const Entry& entry : entries) {
        errors.push_back(
            {*value_over_views(entry, ranking.metric), resampled(ranking.metric, blocks_of(entry), seed)});
        if (entry.front()->role != kBoundRole) ranked.push_back(ranking.places.size());
        ranking.places.push_back(place_of(entry, errors.back(), seed));
    }
    add_ranks(ranking.places, ranked, errors);
    return ranking;
}

/// The entries that succeeded on all of the views, in the order of the first view's cells.
std::vector<Entry> entries_on(const Views& views, const std::vector<CellRecord>& cells) {
    using Contestant = std::array<std::string, 4>;
    const auto contestant = [](const CellRecord& cell) {
        return Contestant{cell.method, cell.preset, cell.setting, cell.filter};
    };
    const auto succeeded_on = [&](const ViewRecord& view, const CellRecord& cell) {
        return cell.view_key == view.key && cell.analysis && value_of(cell.ranked, kNoisyRankingMetric);
    };
    std::vector<Entry> entries;
    for (const CellRecord& first : cells) {
        if (!succeeded_on(*views.front(), first)) continue;
        Entry entry{&first};
        for (std::size_t i = 1; i < views.size(); ++i) {
            const auto found = std::ranges::find_if(cells, [&](const CellRecord& cell) {
                return succeeded_on(*views[i], cell) && contestant(cell) == contestant(first);
            });
            if (found != cells.end()) entry.push_back(&*found);
        }
        if (entry.size() == views.size()) entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace

std::vector<RankingRecord> rank(const std::vector<ViewRecord>& views, const std::vector<CellRecord>& cells,
                                std::uint64_t seed) {
    for (const CellRecord& cell : cells) {
        if (std::ranges::find(views, cell.view_key, &ViewRecord::key) == views.end())
            throw internal_error("a cell of a view that is not there", cell.id);
    }
    std::vector<RankingRecord> rankings;
    const auto add = [&](const Views& group) {
        if (std::vector<Entry> entries = entries_on(group, cells); !entries.empty())
            rankings.push_back(ranking_of(std::move(entries), group, seed));
    };
    Views shown;
    for (const ViewRecord& view : views) {
        if (std::ranges::find(cells, view.key, &CellRecord::view_key) == cells.end()) continue;
        shown.push_back(&view);
        add({&view});
    }
    for (const Views& group : comparable_views(shown)) {
        if (group.size() > 1) add(group);
    }
    return rankings;
}

Results ranked_anew(Results results) {
    if (results.schema_version < Results::kSchemaVersion && results.rankings.empty())
        results.rankings = rank(results.views, results.cells, results.seed);
    return results;
}

}  // namespace aoscore
