#pragma once

#include "core/environment.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace aoscore {

/// The mean radiance of a sky within the cone of half angle `cone_rad`, 0 to pi/2, about a unit axis,
/// weighted by the cosine to the axis.
double mean_within(const Sky& sky, const glm::dvec3& axis, double cone_rad);

/// An environment filtered over cones of eight growing half angles, as irradiance maps hold it (Vermeer,
/// Stochastic-Depth Ambient Occlusion, 2020, section 7.1).
class EnvironmentCones {
  public:
    static constexpr int kMaps = 8;  ///< of half angles pi/2 k/8; below the first the light itself is reached

    explicit EnvironmentCones(const Environment& environment);

    /// The mean radiance within the cone of half angle `cone_rad`, 0 to pi/2, about a unit axis, weighted by
    /// the cosine to the axis: at pi/2 the irradiance of an open surface over pi. Interpolated linearly
    /// between maps by the half angle, and between their texels.
    glm::dvec3 mean_radiance(const glm::dvec3& axis, double cone_rad) const;

  private:
    static constexpr int kRows = 33, kColumns = 64;  // from zenith to nadir, and around
    glm::dvec3 texel(int map, const glm::dvec3& axis) const;

    std::array<std::vector<glm::dvec3>, kMaps + 1> maps_;
};

}  // namespace aoscore
