#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace aoscore {

/// The AO radius of a view's ranking, which methods' lengths follow.
struct RankingRadius {
    double metres = 0;
    bool automatic = false;  ///< nobody chose it
    std::string rule;        ///< its origin: "named by the view", "2 % of the diagonal of …"
};

/// The radii of a scene's views. It finds the scene's main part once, when first needed.
class RankingRadii {
  public:
    /// `scene` must outlive it.
    explicit RankingRadii(const Scene& scene) : scene_(scene) {}
    /// The radius asked for; else the view's; else 2 % of the diagonal of the scene's main part.
    RankingRadius of(const std::optional<double>& asked_m, const View& view);

  private:
    const Scene& scene_;
    std::optional<double> automatic_m_;
};

/// The radius of one view alone.
RankingRadius ranking_radius(const std::optional<double>& asked_m, const View& view, const Scene& scene);

/// The radius of a search among cameras of a scene that are no views yet, metres: the one asked for; else
/// that of the scene's first view that names one; else automatic.
double search_radius_m(const std::optional<double>& asked_m, const Scene& scene);

/// A warning about an automatic radius; empty for one that somebody chose.
std::string radius_warning(const RankingRadius& radius, const View& view);

}  // namespace aoscore
