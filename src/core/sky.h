#pragma once

#include <glm/glm.hpp>

namespace aoscore {

/// Gray light from all around, infinitely far away: a sum of terms whose irradiance is known. Directions are
/// the world's, whose up is +y.
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

/// The sky that pictures are lit by where nobody names another environment: ground, a brighter upper half and
/// a glow to one side, of such strength that an open floor has the irradiance pi.
const Sky& generated_sky();

}  // namespace aoscore
