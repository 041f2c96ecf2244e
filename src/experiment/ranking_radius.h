#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace aoscore {

/// The one AO radius of a view: its ranking's, which methods are drawn for.
struct RankingRadius {
    double metres = 0;
    bool automatic = false;  ///< nobody named it
    std::string rule;        ///< where it comes from: "named by the view", "2 % of the scene's diagonal"
};

/// The radius asked for, else the view's, else 2 % of the scene's diagonal.
RankingRadius ranking_radius(const std::optional<double>& asked_m, const View& view, const Scene& scene);

/// What a reader is to know of an automatic radius; empty for one that somebody named.
std::string radius_warning(const RankingRadius& radius, const View& view);

}  // namespace aoscore
