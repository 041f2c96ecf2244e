#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace aoscore {

/// One traced ray and what it met.
struct ObservedRay {
    glm::vec3 origin;
    glm::vec3 direction;
    std::size_t block = 0;  ///< of its pixel's samples, see block_size()
    bool hit = false;
    double distance_m = 0;  ///< of the nearest hit
    glm::dvec3 normal{0};   ///< of the nearest hit, trace space
};

/// Is told of every ray of a tile's pixels.
class RayObserver {
  public:
    RayObserver() = default;
    RayObserver(const RayObserver&) = delete;
    RayObserver& operator=(const RayObserver&) = delete;
    virtual ~RayObserver() = default;

    /// Begins with so many pixels.
    virtual void start(std::size_t sources) = 0;
    virtual void observe(std::size_t source, const ObservedRay& ray) = 0;
};

}  // namespace aoscore
