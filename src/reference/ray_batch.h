#pragma once

#include "reference/point_sets.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace aoscore {

/// Where the rays of one pixel start and how its hemisphere lies, in trace space.
struct RaySource {
    glm::vec3 origin;
    glm::mat3 frame;     ///< third column: the axis of the hemisphere
    std::uint64_t seed;  ///< of this pixel's point sets
};

/// Rays in one packet.
inline constexpr std::size_t kPacket = 16;

/// The directions of one packet, and the point set that each belongs to: kReplicates times the source, plus
/// the replicate.
struct PacketDirections {
    alignas(64) float x[kPacket];
    alignas(64) float y[kPacket];
    alignas(64) float z[kPacket];
    alignas(64) std::uint32_t owner[kPacket];
};

/// The rays of the pixels of one tile for a range of sample indices, in an order that puts rays of similar
/// direction, whichever pixel they leave from, side by side: packets of them are coherent, while each pixel
/// keeps point sets of its own, so that the noise of neighbours stays independent.
class RayBatch {
  public:
    explicit RayBatch(const PointSets& points) : points_(points) {}

    void clear() { size_ = 0; }
    /// Samples [first, last) of source number `number`.
    void add(const RaySource& source, std::size_t number, int first, int last);
    void sort();

    std::size_t size() const { return size_; }
    /// The direction of ray `i` in the order of add().
    glm::vec3 direction(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
    /// The rays at places [first, first + kPacket) of the sorted order; past the end the last ray is
    /// repeated.
    void packet(std::size_t first, PacketDirections& directions) const;

  private:
    void reserve(std::size_t size);

    const PointSets& points_;
    std::size_t size_ = 0;
    std::vector<float> x_, y_, z_;
    std::vector<std::uint32_t> owner_;
    std::vector<std::uint16_t> cell_;
    std::vector<std::uint32_t> order_;
};

}  // namespace aoscore
