#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace aoscore::testing {

/// A scene of a few triangles, made in code.
class MadeScene {
  public:
    MadeScene();
    /// A box whose faces are wound outwards, or inwards as a room's are.
    MadeScene& box(const glm::dvec3& low, const glm::dvec3& high, bool inwards = false);
    /// A ball of about 1500 triangles, wound outwards.
    MadeScene& ball(const glm::dvec3& centre, double radius);
    MadeScene& triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
    /// Returns the measured scene, all coordinates times `scale`.
    Scene made(double scale = 1) const;

  private:
    void quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);
    std::vector<glm::dvec3> corners_;  // three a triangle
};

}  // namespace aoscore::testing
