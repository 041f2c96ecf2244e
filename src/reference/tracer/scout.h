#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace aoscore {

/// The first hit of a ray.
struct Sight {
    double distance_m = std::numeric_limits<double>::infinity();  ///< infinity where it meets nothing
    bool front = false;  ///< seen from the side that the winding of its triangle calls the front (glTF 2.0)
};

/// The surfaces that a camera sees, from few rays: enough to choose cameras by, not to measure with.
struct Glance {
    struct Point {
        glm::dvec3 position;    ///< scene space
        double depth_m = 0;     ///< view depth
        double visibility = 1;  ///< within the radius, of the few rays
        bool front = false;     ///< as in Sight
    };
    std::vector<Point> points;  ///< of the pixels that show a surface, row by row
    std::size_t pixels = 0;     ///< of the whole picture

    double coverage() const {
        return pixels > 0 ? static_cast<double>(points.size()) / static_cast<double>(pixels) : 0;
    }
};

/// Looks around in a scene before there is a camera to trace a truth for. Any number of threads may ask at
/// once; the answers do not depend on them.
class Scout {
  public:
    /// Builds all of the scene for tracing.
    explicit Scout(const Scene& scene);
    ~Scout();
    Scout(Scout&&) noexcept;
    Scout& operator=(Scout&&) noexcept;

    /// Along a unit direction, scene space.
    Sight first_surface(const glm::dvec3& from, const glm::dvec3& direction) const;
    /// The picture of `frame`, with `rays` cosine-weighted rays of `radius_m` from each of its points.
    Glance look(const CameraFrame& frame, double radius_m, int rays) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aoscore
