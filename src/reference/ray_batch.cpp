#include "reference/ray_batch.h"

#include "reference/truth.h"

#include <array>

namespace aoscore {
namespace {

static_assert(kReplicates == 4, "the point set is stored in two bits");

/// Directions are sorted into kCellsPerSide^2 cells of an octahedron's unfolding, along a Z-order curve.
constexpr unsigned kCellBits = 5;
constexpr float kCellsPerSide = 1u << kCellBits;
constexpr std::size_t kCells = std::size_t{1} << (2 * kCellBits);

/// Moves bit i to bit 2 i.
constexpr std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | (x << 4)) & 0x0f0fu;
    x = (x | (x << 2)) & 0x3333u;
    return (x | (x << 1)) & 0x5555u;
}

/// The cell of a direction on the octahedral map (Cigolle et al., A Survey of Efficient Representations for
/// Independent Unit Vectors, 2014).
std::uint16_t direction_cell(float x, float y, float z) {
    const float scale = 1 / (std::abs(x) + std::abs(y) + std::abs(z));
    float a = x * scale, b = y * scale;
    if (z < 0) {
        const float folded_a = std::copysign(1 - std::abs(b), x);
        b = std::copysign(1 - std::abs(a), y);
        a = folded_a;
    }
    const auto cell = [](float c) {
        return std::min(static_cast<std::uint32_t>((c * 0.5f + 0.5f) * kCellsPerSide), (1u << kCellBits) - 1);
    };
    return static_cast<std::uint16_t>(spread_bits(cell(a)) | (spread_bits(cell(b)) << 1));
}

}  // namespace

void RayBatch::clear() {
    x_.clear();
    y_.clear();
    z_.clear();
    owner_.clear();
    cell_.clear();
}

void RayBatch::add(const RaySource& source, std::uint32_t owner, int first, int last) {
    std::array<std::uint64_t, kReplicates> seeds;
    for (std::uint64_t r = 0; r < kReplicates; ++r) seeds[r] = mix_bits(source.seed + r);
    for (int k = first; k < last; ++k) {
        const auto replicate = static_cast<std::uint32_t>(k % kReplicates);
        const auto index = static_cast<std::uint32_t>(k / kReplicates);
        const auto seed_u = static_cast<std::uint32_t>(seeds[replicate]);
        const auto seed_v = static_cast<std::uint32_t>(seeds[replicate] >> 32);
        const float u = unit_interval(owen_scramble_reversed(index, seed_u));
        const float v = unit_interval(owen_scramble_reversed(sobol_y_reversed(index), seed_v));
        const glm::vec3 d = source.frame * cosine_hemisphere(u, v);
        x_.push_back(d.x);
        y_.push_back(d.y);
        z_.push_back(d.z);
        owner_.push_back(owner << 2 | replicate);
        cell_.push_back(direction_cell(d.x, d.y, d.z));
    }
}

void RayBatch::sort() {
    std::array<std::uint32_t, kCells + 1> start{};
    for (const std::uint16_t cell : cell_) ++start[cell + 1u];
    for (std::size_t c = 0; c < kCells; ++c) start[c + 1] += start[c];
    order_.resize(size());
    for (std::uint32_t i = 0; i < cell_.size(); ++i) order_[start[cell_[i]]++] = i;
}

}  // namespace aoscore
