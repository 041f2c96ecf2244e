#include "reference/tracer/ray_batch.h"

#include "core/sampling.h"
#include "reference/integrator/vectorise.h"
#include "reference/sampling/z_order.h"
#include "reference/tracer/transpose.h"
#include "reference/truth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace aoscore {
namespace {

/// Directions are sorted into cells of an octahedron's unfolding, along a Z-order curve.
constexpr unsigned kCellBits = 5;
constexpr int kCellsPerSide = 1 << kCellBits;
constexpr std::size_t kCells = std::size_t{kCellsPerSide} * kCellsPerSide;

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
    return static_cast<std::uint16_t>(z_order(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)));
}

/// Consecutive points of a set, those of one pixel.
struct PointRange {
    const std::uint32_t* u;
    const std::uint32_t* v;
    std::uint32_t first;  ///< its index in the set
    std::size_t count;
    std::uint32_t shift_u, shift_v;  ///< of this pixel
    std::uint32_t owner;             ///< of the pixel's first block
    unsigned block_bits;             ///< log2 of the samples in a block
};

/// Writes `count` rays one after the other.
[[gnu::always_inline]] inline void store_rays(const float* x, const float* y, const float* z,
                                              const std::uint32_t* owner, std::size_t count,
                                              DirectedRay* rays) {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        FourWords a = four_words(x + i), b = four_words(y + i), c = four_words(z + i),
                  d = four_words(owner + i);
        transpose(a, b, c, d);
        std::memcpy(rays + i, &a, sizeof a);
        std::memcpy(rays + i + 1, &b, sizeof b);
        std::memcpy(rays + i + 2, &c, sizeof c);
        std::memcpy(rays + i + 3, &d, sizeof d);
    }
    for (; i < count; ++i) rays[i] = {x[i], y[i], z[i], owner[i]};
}

/// Directions that are made before they are stored ray by ray: the stores are shuffles of what is still at
/// hand.
constexpr std::size_t kPiece = 64;

template <auto direction_of>
[[gnu::always_inline]] inline void make_by(const PointRange& points, const glm::mat3& frame,
                                           DirectedRay* __restrict rays, std::uint16_t* __restrict cell) {
    const glm::vec3 s = frame[0], t = frame[1], n = frame[2];
    const std::uint32_t* __restrict u = points.u, * __restrict v = points.v;
    const std::uint32_t shift_u = points.shift_u, shift_v = points.shift_v;
    const std::uint32_t owner = points.owner, first = points.first;
    const unsigned block_bits = points.block_bits;
    alignas(64) float x[kPiece], y[kPiece], z[kPiece];
    alignas(64) std::uint32_t owners[kPiece];
    for (std::size_t begin = 0; begin < points.count; begin += kPiece) {
        const std::size_t count = std::min(kPiece, points.count - begin);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = begin + k;
            const glm::vec3 d = direction_of(unit_interval(u[i] ^ shift_u), unit_interval(v[i] ^ shift_v));
            x[k] = s.x * d.x + t.x * d.y + n.x * d.z;
            y[k] = s.y * d.x + t.y * d.y + n.y * d.z;
            z[k] = s.z * d.x + t.z * d.y + n.z * d.z;
            owners[k] = owner + ((first + static_cast<std::uint32_t>(i)) >> block_bits);
            cell[i] = direction_cell(x[k], y[k], z[k]);
        }
        store_rays(x, y, z, owners, count, rays + begin);
    }
}

AOSCORE_VECTORISE
void make_cosine_directions(const PointRange& points, const glm::mat3& frame, DirectedRay* __restrict rays,
                            std::uint16_t* __restrict cell) {
    make_by<cosine_hemisphere>(points, frame, rays, cell);
}

AOSCORE_VECTORISE
void make_uniform_directions(const PointRange& points, const glm::mat3& frame, DirectedRay* __restrict rays,
                             std::uint16_t* __restrict cell) {
    make_by<uniform_hemisphere>(points, frame, rays, cell);
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
    const auto owner = static_cast<std::uint32_t>(number * kBlocks);
    const PointRange points{set.u + first,
                            set.v + first,
                            static_cast<std::uint32_t>(first),
                            static_cast<std::size_t>(last - first),
                            static_cast<std::uint32_t>(shifts),
                            static_cast<std::uint32_t>(shifts >> 32),
                            owner,
                            static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(block)))};
    const auto make = density_ == RayDensity::cosine ? make_cosine_directions : make_uniform_directions;
    make(points, source.frame, &rays_[size_], &cell_[size_]);
    size_ += points.count;
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
