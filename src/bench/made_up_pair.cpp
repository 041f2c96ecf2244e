#include "bench/made_up_pair.h"

#include <cmath>
#include <random>

namespace aoscore {

MadeUpPair::MadeUpPair(int width, int height, std::uint64_t seed)
    : first_half(width, height), second_half(width, height), truth(width, height), test(width, height) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> noise(-0.05F, 0.05F);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float slope =
                0.6F + 0.25F * std::sin(0.011F * static_cast<float>(x) + 0.007F * static_cast<float>(y));
            const float edge = (x / 171 + y / 97) % 3 == 0 ? 0.2F : 0.0F;
            first_half.at(x, y) = slope - edge + noise(random);
            second_half.at(x, y) = slope - edge + noise(random);
            truth.at(x, y) = (first_half.at(x, y) + second_half.at(x, y)) / 2;
            test.at(x, y) = 0.9F * slope - 0.5F * edge + 0.1F + noise(random);
        }
    }
}

}  // namespace aoscore
