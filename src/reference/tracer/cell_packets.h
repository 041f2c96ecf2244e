#pragma once

#include "reference/sampling/point_cells.h"
#include "reference/tracer/ray_batch.h"
#include "reference/tracer/ray_packet.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace aoscore {

/// Whether the axes of two hemispheres, and the zeros of their azimuths, lie within 16 degrees of each other,
/// so that the same part of each looks much the same way. Columns are unit, the third is the axis.
bool lie_alike(const glm::mat3& a, const glm::mat3& b);

/// The rays of neighbouring pixels whose hemispheres lie alike, in packets that need no sorting: the points
/// of a pixel are a net, which has one point in each cell of the square, so that for every cell all pixels'
/// rays follow one after the other.
class CellPackets {
  public:
    /// Pixels at least and at most.
    static constexpr std::size_t kLeast = kPacket, kMost = 2 * kPacket;

    /// Begins with no pixel. `cells` must outlive this. Blocks have `block` samples, a power of two.
    void start(const PointCells& cells, RayDensity density, int block);
    /// `owner`: of the pixel's first block.
    void add(const RaySource& source, std::uint32_t owner);
    /// After the last pixel: at least kLeast.
    void close();

    /// Rays.
    std::size_t size() const { return pixels_ * static_cast<std::size_t>(cells_->size()); }
    /// Writes the origins, directions and owners (as ids) of rays [first, first + kPacket) to a packet. Lanes
    /// beyond the last ray repeat rays of the last cell.
    void fill(RayPacket& packet, std::size_t first) const;

  private:
    /// One value a pixel, and the first ones again: a packet may reach from the last pixels of a cell to the
    /// first ones of the next.
    template <class T>
    using Lanes = std::array<T, kMost + kPacket>;

    const PointCells* cells_ = nullptr;
    RayDensity density_ = RayDensity::cosine;
    unsigned block_bits_ = 0;
    std::size_t pixels_ = 0;
    Lanes<float> origin_[3], frame_[3][3];
    Lanes<std::uint64_t> shift_;
    Lanes<std::uint32_t> shift_cell_, set_begin_, owner_;
};

}  // namespace aoscore
