#include "reference/tracer/cell_packets.h"

#include "core/sampling.h"
#include "reference/integrator/vectorise.h"

#include <algorithm>
#include <bit>

namespace aoscore {
namespace {

/// The cosine of 16 degrees.
constexpr float kAlike = 0.96f;

}  // namespace

bool lie_alike(const glm::mat3& a, const glm::mat3& b) {
    return glm::dot(a[2], b[2]) > kAlike && glm::dot(a[0], b[0]) > kAlike;
}

void CellPackets::start(const PointCells& cells, RayDensity density, int block) {
    cells_ = &cells;
    density_ = density;
    block_bits_ = static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(block)));
    pixels_ = 0;
}

void CellPackets::add(const RaySource& source, std::uint32_t owner) {
    const std::uint64_t shifts = mix_bits(source.seed);
    const std::size_t i = pixels_++;
    for (int axis = 0; axis < 3; ++axis) {
        origin_[axis][i] = source.origin[axis];
        for (int column = 0; column < 3; ++column) frame_[column][axis][i] = source.frame[column][axis];
    }
    const auto shift_u = static_cast<std::uint32_t>(shifts),
               shift_v = static_cast<std::uint32_t>(shifts >> 32);
    shift_[i] = point_word(shift_u, shift_v, 0);
    shift_cell_[i] = cells_->cell(shift_u, shift_v);
    set_begin_[i] = static_cast<std::uint32_t>(PointSets::number(mix_bits(shifts)) *
                                               static_cast<std::size_t>(cells_->size()));
    owner_[i] = owner;
}

void CellPackets::close() {
    const auto repeat = [this](auto& lanes) {
        std::copy_n(lanes.begin(), kPacket, lanes.begin() + static_cast<std::ptrdiff_t>(pixels_));
    };
    for (int axis = 0; axis < 3; ++axis) {
        repeat(origin_[axis]);
        for (int column = 0; column < 3; ++column) repeat(frame_[column][axis]);
    }
    repeat(shift_);
    for (auto* lanes : {&shift_cell_, &set_begin_, &owner_}) repeat(*lanes);
}

namespace {

/// Where the values of sixteen neighbouring lanes begin.
struct LaneValues {
    const float* origin[3];
    const float* frame[3][3];
    const std::uint64_t* shift;
    const std::uint32_t *shift_cell, *set_begin, *owner;
};

struct CellRange {
    std::uint32_t cell, last;  ///< of the first lanes; of all
    std::uint32_t lanes;       ///< that are in that cell; those after them are in the next one
    unsigned block_bits;
};

template <auto direction_of>
[[gnu::always_inline]] inline void fill_by(RayPacket& __restrict packet, const PointCells& cells,
                                           const LaneValues& of, const CellRange& range) {
    const std::uint64_t* __restrict points = cells.points();
    const std::uint64_t* __restrict shift = of.shift;
    const std::uint32_t* __restrict shift_cell = of.shift_cell;
    const std::uint32_t* __restrict set_begin = of.set_begin;
    const std::uint32_t* __restrict owner = of.owner;
    const float* __restrict sx = of.frame[0][0], * __restrict sy = of.frame[0][1], * __restrict sz = of.frame[0][2];
    const float* __restrict tx = of.frame[1][0], * __restrict ty = of.frame[1][1], * __restrict tz = of.frame[1][2];
    const float* __restrict nx = of.frame[2][0], * __restrict ny = of.frame[2][1], * __restrict nz = of.frame[2][2];
    const std::uint32_t first = range.cell, last = range.last, lanes = range.lanes;
    const auto number = static_cast<std::uint32_t>(cells.first());
    const unsigned block_bits = range.block_bits;
    alignas(64) std::uint64_t words[kPacket];
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
        const std::uint32_t next = first + (lane >= lanes ? 1u : 0u);
        const std::uint32_t cell = next < last ? next : last;
        const std::uint32_t point = set_begin[lane] + (cell ^ shift_cell[lane]);
        words[lane] = points[point] ^ shift[lane];
    }
    for (std::size_t lane = 0; lane < kPacket; ++lane)
        packet.id[lane] = owner[lane] + ((number + word_number(words[lane])) >> block_bits);
    float* __restrict x = packet.direction_x, * __restrict y = packet.direction_y, * __restrict z = packet.direction_z;
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
        const glm::vec3 d =
            direction_of(unit_interval(word_u(words[lane])), unit_interval(word_v(words[lane])));
        x[lane] = sx[lane] * d.x + tx[lane] * d.y + nx[lane] * d.z;
        y[lane] = sy[lane] * d.x + ty[lane] * d.y + ny[lane] * d.z;
        z[lane] = sz[lane] * d.x + tz[lane] * d.y + nz[lane] * d.z;
    }
    std::copy_n(of.origin[0], kPacket, packet.origin_x);
    std::copy_n(of.origin[1], kPacket, packet.origin_y);
    std::copy_n(of.origin[2], kPacket, packet.origin_z);
}

AOSCORE_VECTORISE
void fill_cosine(RayPacket& packet, const PointCells& cells, const LaneValues& of, const CellRange& range) {
    fill_by<cosine_hemisphere>(packet, cells, of, range);
}

AOSCORE_VECTORISE
void fill_uniform(RayPacket& packet, const PointCells& cells, const LaneValues& of, const CellRange& range) {
    fill_by<uniform_hemisphere>(packet, cells, of, range);
}

}  // namespace

void CellPackets::fill(RayPacket& packet, std::size_t first) const {
    // Of 32 bits, since wider quotients take several times as long.
    const auto place = static_cast<std::uint32_t>(first), pixels = static_cast<std::uint32_t>(pixels_);
    const std::uint32_t cell = place / pixels, begin = place % pixels;
    LaneValues of{};
    for (int axis = 0; axis < 3; ++axis) {
        of.origin[axis] = &origin_[axis][begin];
        for (int column = 0; column < 3; ++column) of.frame[column][axis] = &frame_[column][axis][begin];
    }
    of.shift = &shift_[begin];
    of.shift_cell = &shift_cell_[begin];
    of.set_begin = &set_begin_[begin];
    of.owner = &owner_[begin];
    const CellRange range{cell, static_cast<std::uint32_t>(cells_->size() - 1),
                          std::min(pixels - begin, std::uint32_t{kPacket}), block_bits_};
    (density_ == RayDensity::cosine ? fill_cosine : fill_uniform)(packet, *cells_, of, range);
}

}  // namespace aoscore
