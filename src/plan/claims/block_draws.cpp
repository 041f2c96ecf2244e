#include "plan/claims/block_draws.h"

#include <cmath>
#include <cstddef>
#include <random>

namespace aoscore {
namespace {

constexpr int kBlockDraws = 2000;

}  // namespace

Measured over_blocks(const std::vector<const std::vector<double>*>& of,
                     const std::function<double(const std::vector<double>& sums)>& value_of,
                     std::uint64_t seed) {
    std::vector<double> sums(of.size(), 0);
    for (std::size_t k = 0; k < of.size(); ++k) {
        for (const double block : *of[k]) sums[k] += block;
    }
    Measured measured;
    const double value = value_of(sums);
    if (!std::isfinite(value)) return measured;
    measured.value = value;
    const std::size_t blocks = of.front()->size();
    std::mt19937_64 random(seed);
    for (int i = 0; i < kBlockDraws; ++i) {
        sums.assign(of.size(), 0);
        for (std::size_t drawn = 0; drawn < blocks; ++drawn) {
            const std::size_t block = random() % blocks;
            for (std::size_t k = 0; k < of.size(); ++k) sums[k] += (*of[k])[block];
        }
        measured.draws.push_back(value_of(sums));
    }
    return measured;
}

}  // namespace aoscore
