#pragma once

#include "metrics/intervals/over_scenes.h"
#include "page/index/index_contents.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A contestant over all scenes of an index.
struct ScenePlace {
    std::size_t contestant = 0;
    double error = 0;  ///< error_over_scenes()
    /// Of this error alone, 95 %, over other scenes and cameras; empty where there is only one of them.
    std::optional<Interval> interval;
    std::optional<RankRange> rank;         ///< all ranks hold at once; empty for a bound
    std::optional<Interval> behind_first;  ///< of its error less the first ranked one's; empty for that one
    std::size_t worst_cell = 0;            ///< where it errs most, a place in IndexContents::cells
    std::optional<double> ms, fetches;     ///< medians over the cells that have them
};

/// Contestants that were all scored on the same views, least error first.
struct SceneRanking {
    std::size_t scenes = 0, views = 0;  ///< those that are ranked over
    std::vector<ScenePlace> places;
    std::size_t left_out = 0;  ///< contestants that were not scored on all of these views
};

/// Ranks the contestants on the views that they share. Where not every one was scored on every view, those
/// with most views are taken as long as the number of cells that are compared grows by it.

SceneRanking rank_over_scenes(const IndexContents& contents, std::uint64_t seed);

/// Says in a sentence which contestant is closest over the scenes.
std::string scene_sentence(const SceneRanking& ranking, const IndexContents& contents);

}  // namespace aoscore
