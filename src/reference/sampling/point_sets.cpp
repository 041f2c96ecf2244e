#include "reference/sampling/point_sets.h"

#include "core/sampling.h"

namespace aoscore {

PointSets::PointSets(PointKind kind, int points)
    : kind_(kind), points_(static_cast<std::size_t>(points)), u_(kSets * points_), v_(kSets * points_) {
    for (std::size_t set = 0; set < kSets; ++set) {
        const std::uint64_t seeds = mix_bits(set);
        for (std::size_t i = 0; i < points_; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            std::uint32_t& u = u_[set * points_ + i];
            std::uint32_t& v = v_[set * points_ + i];
            if (kind == PointKind::scrambled_sobol) {
                u = owen_scramble_reversed(index, static_cast<std::uint32_t>(seeds));
                v = owen_scramble_reversed(sobol_y_reversed(index), static_cast<std::uint32_t>(seeds >> 32));
            } else {
                const std::uint64_t bits = mix_bits(seeds ^ mix_bits(i));
                u = static_cast<std::uint32_t>(bits);
                v = static_cast<std::uint32_t>(bits >> 32);
            }
        }
    }
}

}  // namespace aoscore
