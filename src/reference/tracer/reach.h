#pragma once

#include "scene/camera.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore {

/// Tells which instances of a scene matter to a picture: what none of its rays can meet need not be built.
class Reach {
  public:
    /// Keeps a box of every instance; `scene` need not live on.
    explicit Reach(const Scene& scene);

    /// One flag an instance of the scene, 0 where it surely lies farther than `reach_m` metres (0 or more,
    /// infinity allowed) from all that the camera may see: neither a ray through a pixel nor one of that
    /// length from what it meets between the near and far plane can meet the instance.
    std::vector<char> instances(const CameraFrame& frame, double reach_m) const;

  private:
    /// The box of a mesh where its instance lies, in scene space.
    struct PlacedBox {
        glm::dvec3 centre{0};
        glm::dmat3 half_edges{0.0};  ///< from the centre to the middles of three sides
    };
    std::vector<PlacedBox> boxes_;
    Bounds bounds_;  // of all boxes
};

}  // namespace aoscore
