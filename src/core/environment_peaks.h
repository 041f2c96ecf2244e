#pragma once

#include "core/environment.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// Divides the light of an environment in two: what exceeds a multiple of its mean luminance, such as a sun,
/// as a distribution of directions to send rays to, and the rest, which rays in all directions see with
/// little noise. Both add up to the environment.
class EnvironmentPeaks {
  public:
    explicit EnvironmentPeaks(const Environment& environment);

    /// Whether nothing exceeds it: a sky's light never does.
    bool empty() const { return texels_.empty(); }
    /// What a radiance of the environment keeps without its peak.
    glm::dvec3 rest(const glm::dvec3& radiance) const;

    struct Sample {
        glm::dvec3 from;                ///< unit
        glm::dvec3 radiance_by_chance;  ///< the peak's radiance over the density of this direction
    };
    /// The direction at a point of the unit square: densities go with the peak's luminance.
    Sample sample(double u, double v) const;

  private:
    struct Texel {
        int x, y;
        double up_to;  ///< share of the peaks' luminance of this texel and all before
    };
    const EnvironmentMap* map_;
    double limit_ = 0;  ///< luminance
    double total_ = 0;  ///< of the peaks' luminance over solid angle
    std::vector<Texel> texels_;
};

}  // namespace aoscore
