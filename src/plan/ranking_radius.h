#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace aoscore {

/// The one AO radius of a view: its ranking's, which methods are drawn for.
struct RankingRadius {
    double metres = 0;
    bool automatic = false;  ///< nobody named it
    std::string rule;        ///< where it comes from: "named by the view", "2 % of the diagonal of …"
};

/// The radii of a scene's views. What it needs to know of the scene is found out once, when first needed.
class RankingRadii {
  public:
    /// `scene` must outlive it.
    explicit RankingRadii(const Scene& scene) : scene_(scene) {}
    /// The radius asked for, else the view's, else 2 % of the diagonal of the scene's main part.
    RankingRadius of(const std::optional<double>& asked_m, const View& view);

  private:
    const Scene& scene_;
    std::optional<double> automatic_m_;
};

/// The same for one view.
RankingRadius ranking_radius(const std::optional<double>& asked_m, const View& view, const Scene& scene);

/// What a reader is to know of an automatic radius; empty for one that somebody named.
std::string radius_warning(const RankingRadius& radius, const View& view);

}  // namespace aoscore
