#include "reference/ray_batch.h"

#include "core/sampling.h"
#include "reference/truth.h"
#include "reference/vectorise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aoscore {
namespace {

/// Directions are sorted into cells of an octahedron's unfolding, along a Z-order curve.
constexpr unsigned kCellBits = 5;
constexpr int kCellsPerSide = 1 << kCellBits;
constexpr std::size_t kCells = std::size_t{kCellsPerSide} * kCellsPerSide;

/// Moves bit i to bit 2 i.
inline std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | (x << 4)) & 0x0f0fu;
    x = (x | (x << 2)) & 0x3333u;
    return (x | (x << 1)) & 0x5555u;
}

/// The cell of a direction on the octahedral map (Cigolle et al., A Survey of Efficient Representations for
/// Independent Unit Vectors, 2014). Only an order: it need not be exact, and both halves may share a fold.
inline std::uint16_t direction_cell(float x, float y, float z) {
    const float scale = 1 / (std::abs(x) + std::abs(y) + std::abs(z));
    const float a = x * scale, b = y * scale;
    const float folded_a = std::copysign(1 - std::abs(b), x);
    const float folded_b = std::copysign(1 - std::abs(a), y);
    constexpr float kHalf = kCellsPerSide / 2;
    const int i = std::min(static_cast<int>((z < 0 ? folded_a : a) * kHalf + kHalf), kCellsPerSide - 1);
    const int j = std::min(static_cast<int>((z < 0 ? folded_b : b) * kHalf + kHalf), kCellsPerSide - 1);
    return static_cast<std::uint16_t>(spread_bits(static_cast<std::uint32_t>(i)) |
                                      (spread_bits(static_cast<std::uint32_t>(j)) << 1));
}

AOSCORE_VECTORISE
void make_directions(const std::uint32_t* __restrict u, const std::uint32_t* __restrict v, std::size_t count,
                     std::uint32_t shift_u, std::uint32_t shift_v, const glm::mat3& frame,
                     std::uint32_t owner, DirectedRay* __restrict rays, std::uint16_t* __restrict cell) {
    const glm::vec3 s = frame[0], t = frame[1], n = frame[2];
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 d = cosine_hemisphere(unit_interval(u[i] ^ shift_u), unit_interval(v[i] ^ shift_v));
        const float x = s.x * d.x + t.x * d.y + n.x * d.z;
        const float y = s.y * d.x + t.y * d.y + n.y * d.z;
        const float z = s.z * d.x + t.z * d.y + n.z * d.z;
        rays[i].x = x;
        rays[i].y = y;
        rays[i].z = z;
        rays[i].owner = owner;
        cell[i] = direction_cell(x, y, z);
    }
}

}  // namespace

void RayBatch::reserve(std::size_t size) {
    if (size <= rays_.size()) return;
    size = std::max(size, 2 * rays_.size());
    rays_.resize(size);
    cell_.resize(size);
}

void RayBatch::add(const RaySource& source, std::size_t number, int first, int last, int block) {
    const std::uint64_t shifts = mix_bits(source.seed);
    const PointSets::Coordinates set = points_.set(mix_bits(shifts));
    reserve(size_ + static_cast<std::size_t>(last - first));
    while (first < last) {
        const int index = first / block;
        const int end = std::min(last, (index + 1) * block);
        const auto count = static_cast<std::size_t>(end - first);
        const std::size_t owner = number * kBlocks + static_cast<std::size_t>(index);
        make_directions(set.u + first, set.v + first, count, static_cast<std::uint32_t>(shifts),
                        static_cast<std::uint32_t>(shifts >> 32), source.frame,
                        static_cast<std::uint32_t>(owner), &rays_[size_], &cell_[size_]);
        if (owner >= rays_of_.size()) rays_of_.resize(owner + 1);
        rays_of_[owner] += static_cast<std::uint32_t>(count);
        size_ += count;
        first = end;
    }
}

void RayBatch::sort() {
    std::array<std::uint32_t, kCells + 1> start{};
    for (std::size_t i = 0; i < size_; ++i) ++start[cell_[i] + 1u];
    for (std::size_t c = 0; c < kCells; ++c) start[c + 1] += start[c];
    if (sorted_.size() < size_ + kPacket) sorted_.resize(size_ + kPacket);
    for (std::size_t i = 0; i < size_; ++i) sorted_[start[cell_[i]]++] = rays_[i];
    std::fill_n(sorted_.begin() + static_cast<std::ptrdiff_t>(size_), kPacket,
                size_ > 0 ? sorted_[size_ - 1] : DirectedRay{});
}

}  // namespace aoscore
