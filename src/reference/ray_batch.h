#pragma once

#include "core/sampling.h"

#include <cstdint>
#include <vector>

namespace aoscore {

/// Where the rays of one pixel start and how its hemisphere lies, in trace space.
struct RaySource {
    glm::vec3 origin;
    glm::mat3 frame;     ///< third column: the axis of the hemisphere
    std::uint64_t seed;  ///< of this pixel's point sets
};

/// The rays of the pixels of one tile for a range of sample indices, in an order that puts rays of similar
/// direction, whichever pixel they leave from, side by side: packets of them are coherent, while each pixel
/// keeps point sets of its own, so that the noise of neighbours stays independent.
class RayBatch {
  public:
    void clear();
    /// Samples [first, last) of a source; `owner` comes back with each ray.
    void add(const RaySource& source, std::uint32_t owner, int first, int last);
    void sort();

    std::size_t size() const { return x_.size(); }
    struct Ray {
        glm::vec3 direction;
        std::uint32_t owner;
        std::uint32_t replicate;
    };
    /// The ray at `place` of the sorted order.
    Ray sorted(std::size_t place) const {
        const std::uint32_t i = order_[place];
        return {{x_[i], y_[i], z_[i]}, owner_[i] >> 2, owner_[i] & 3u};
    }

  private:
    std::vector<float> x_, y_, z_;
    std::vector<std::uint32_t> owner_;  // owner, then the point set in the last two bits
    std::vector<std::uint16_t> cell_;
    std::vector<std::uint32_t> order_;
};

}  // namespace aoscore
