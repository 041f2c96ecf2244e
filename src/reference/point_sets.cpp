#include "reference/point_sets.h"

#include "core/sampling.h"

namespace aoscore {

PointSets::PointSets(int points)
    : points_(static_cast<std::size_t>(points)), u_(kSets * points_), v_(kSets * points_) {
    for (std::size_t set = 0; set < kSets; ++set) {
        const std::uint64_t seeds = mix_bits(set);
        for (std::size_t i = 0; i < points_; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            u_[set * points_ + i] = owen_scramble_reversed(index, static_cast<std::uint32_t>(seeds));
            v_[set * points_ + i] =
                owen_scramble_reversed(sobol_y_reversed(index), static_cast<std::uint32_t>(seeds >> 32));
        }
    }
}

}  // namespace aoscore
