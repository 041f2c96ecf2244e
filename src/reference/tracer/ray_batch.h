#pragma once

#include "reference/sampling/point_sets.h"
#include "reference/tracer/ray_packet.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace aoscore {

/// Where the rays of one pixel start and how its hemisphere lies, in trace space.
struct RaySource {
    glm::vec3 origin;
    glm::mat3 frame;     ///< third column: the axis of the hemisphere
    std::uint64_t seed;  ///< of this pixel's points
};

/// A direction, and the sum that it counts for: kBlocks times the source, plus the block.
struct DirectedRay {
    float x, y, z;
    std::uint32_t owner;
};

/// How directions are spread over the hemisphere.
enum class RayDensity : std::uint8_t { cosine, uniform };

/// The rays of the pixels of one tile for a range of sample indices, in an order that puts rays of similar
/// direction, whichever pixel they leave from, side by side: packets of them are coherent, while each pixel
/// keeps point sets of its own, so that the noise of neighbours stays independent.
class RayBatch {
  public:
    explicit RayBatch(const PointSets& points, RayDensity density = RayDensity::cosine)
        : points_(points), density_(density) {}

    void clear() { size_ = 0; }
    /// Samples [first, last) of source number `number`, in blocks of `block` samples, a power of two.
    void add(const RaySource& source, std::size_t number, int first, int last, int block);
    void sort();

    std::size_t size() const { return size_; }
    /// In the order of add(), and sorted: there kPacket copies of the last one follow.
    const std::vector<DirectedRay>& rays() const { return rays_; }
    const DirectedRay* sorted() const { return sorted_.data(); }

  private:
    void reserve(std::size_t size);

    const PointSets& points_;
    RayDensity density_;
    std::size_t size_ = 0;
    std::vector<DirectedRay> rays_, sorted_;
    std::vector<std::uint16_t> cell_;
};

}  // namespace aoscore
