#pragma once

#include "core/image.h"
#include "metrics/metric.h"

#include <cmath>
#include <functional>
#include <random>

namespace aoscore::testing {

/// Truth, test image and mask, all of whose pixels are valid at first.
struct Pair {
    ImageF truth, test;
    Mask valid;

    Pair(int width, int height) : truth(width, height), test(width, height), valid(width, height, 1) {}
    MetricInput input(const ImageF* standard_error = nullptr) const {
        return {truth, test, valid, standard_error};
    }
};

/// Makes a pair from 8-bit gray levels, which are functions of the pixel.
inline Pair pair_of_levels(int width, int height, const std::function<int(int, int)>& truth,
                           const std::function<int(int)>& test_of_truth) {
    Pair pair(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int level = truth(x, y);
            pair.truth.at(x, y) = static_cast<float>(level) / 255.0F;
            pair.test.at(x, y) = static_cast<float>(test_of_truth(level)) / 255.0F;
        }
    }
    return pair;
}

/// A pair with flat parts, slopes, edges and noise, like visibility.
inline Pair natural_pair(int width, int height, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> noise(-0.05F, 0.05F);
    Pair pair(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float slope =
                0.5F + 0.3F * std::sin(0.07F * static_cast<float>(x) + 0.02F * static_cast<float>(y));
            const float edge = (x / 17 + y / 23) % 3 == 0 ? 0.2F : 0.0F;
            pair.truth.at(x, y) = slope - edge + noise(random);
            pair.test.at(x, y) = 0.9F * slope - 0.5F * edge + 0.1F + noise(random);
        }
    }
    return pair;
}

/// Leaves about `share` of the pixels valid: coarse blobs and single pixels.
inline void mask_out(Pair& pair, double share, unsigned seed = 2) {
    std::mt19937 random(seed);
    std::bernoulli_distribution lone(0.1), blob(1 - share);
    for (int y = 0; y < pair.valid.height; y += 8) {
        for (int x = 0; x < pair.valid.width; x += 8) {
            const bool out = blob(random);
            for (int i = 0; i < 64; ++i) {
                const int px = x + i % 8, py = y + i / 8;
                if (px >= pair.valid.width || py >= pair.valid.height) continue;
                if (out || lone(random)) pair.valid.at(px, py) = 0;
            }
        }
    }
}

}  // namespace aoscore::testing
