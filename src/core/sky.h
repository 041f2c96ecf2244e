#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace aoscore {

/// Light from all around, infinitely far away: a sum of terms whose irradiance is known. Directions are the
/// world's, whose up is +y.
struct Sky {
    double even = 0;            ///< radiance from everywhere
    double slope = 0;           ///< radiance times the cosine to the zenith, below the horizon too
    double upper = 0;           ///< radiance from above the horizon alone
    double glow = 0;            ///< radiance at `glow_from`, a broad spot beside the zenith
    double glow_sharpness = 6;  ///< the spot falls off as exp(sharpness (cosine - 1))
    glm::dvec3 glow_from{0.48, 0.8, 0.36};  ///< unit

    /// Radiance from a unit direction.
    double radiance(const glm::dvec3& from) const;
};

/// The sky that pictures are lit by: ground, a brighter upper half and a glow to one side, of such strength
/// that an open floor has the irradiance pi.
const Sky& generated_sky();

/// A sky filtered over cones of eight growing half angles, as irradiance maps hold it (Vermeer,
/// Stochastic-Depth Ambient Occlusion, 2020, section 7.1).
class SkyCones {
  public:
    static constexpr int kMaps = 8;  ///< of half angles pi/2 k/8; below the first the sky itself is reached

    explicit SkyCones(const Sky& sky);

    /// The mean radiance within the cone of half angle `cone_rad`, 0 to pi/2, about a unit axis, weighted by
    /// the cosine to the axis: at pi/2 the irradiance of an open surface over pi. Interpolated linearly
    /// between maps by the half angle, and between their texels.
    double mean_radiance(const glm::dvec3& axis, double cone_rad) const;

  private:
    static constexpr int kRows = 33, kColumns = 64;  // from zenith to nadir, and around
    double texel(int map, const glm::dvec3& axis) const;

    std::array<std::vector<double>, kMaps + 1> maps_;
};

}  // namespace aoscore
