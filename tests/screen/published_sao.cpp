#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

struct Sao {
    const Picture& picture;
    DepthLevels levels;
    double radius;

    double operator()(int px, int py) const {
        const dvec3 p = picture.point(px, py), n = picture.face_normal(px, py);
        const double disc = radius * picture.pixels_per_metre(-p.z), r2 = radius * radius;
        const long hash = (3L * px) ^ (py + static_cast<long>(px) * py);
        const double spin = std::fmod(static_cast<double>(hash) * 10, 2 * std::numbers::pi);
        double sum = 0;
        for (int i = 0; i < 11; ++i) {
            const double alpha = (i + 0.5) / 11, angle = alpha * 7 * 2 * std::numbers::pi + spin;
            const double away = alpha * disc;
            const int level = std::clamp(static_cast<int>(std::floor(std::log2(away))) - 3, 0, 5);
            const int tx = px + static_cast<int>(away * std::cos(angle)),
                      ty = py + static_cast<int>(away * std::sin(angle));
            const dvec3 v = picture.point(tx + 0.5, ty + 0.5, levels.depth(level, tx, ty)) - p;
            const double vv = glm::dot(v, v), f = std::max(r2 - vv, 0.0);
            sum += f * f * f * std::max((glm::dot(v, n) - 0.01) / (0.01 + vv), 0.0);
        }
        return std::max(0.0, 1 - sum / std::pow(r2, 3) * 5 / 11);
    }
};

ImageF quad_means(const Picture& picture, const ImageF& image) {
    ImageF result = image;
    for (const bool rows : {true, false}) {
        const ImageF before = result;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const int bx = rows ? x ^ 1 : x, by = rows ? y : y ^ 1;
                if (bx >= image.width || by >= image.height) continue;
                const bool level = std::abs(picture.depth(x, y) - picture.depth(bx, by)) < 0.02;
                if (level) result.at(x, y) = (before.at(x, y) + before.at(bx, by)) / 2;
            }
        }
    }
    return result;
}

ImageF blurred(const Picture& picture, const ImageF& image, int dx, int dy) {
    // The tabulated Gaussian, whose first step is a factor of 0.144893/0.153170.
    constexpr double kGaussian[] = {0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            double weights = kGaussian[0], sum = weights * static_cast<double>(image.at(x, y));
            for (int r = -4; r <= 4; ++r) {
                if (r == 0) continue;
                const int tx = x + 2 * r * dx, ty = y + 2 * r * dy;
                const double apart = std::abs(picture.depth(tx, ty) - picture.depth(x, y)) / 300;
                const double weight = (0.3 + kGaussian[std::abs(r)]) * std::max(0.0, 1 - 2000 * apart);
                sum += weight * clamped(image, tx, ty);
                weights += weight;
            }
            result.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return result;
}

}  // namespace

Estimator sao(const Picture& picture, double radius) {
    return Sao{picture, DepthLevels(picture, rotated_pick), radius};
}

ImageF sao_blurred(const Picture& picture, const ImageF& visibility) {
    return blurred(picture, blurred(picture, quad_means(picture, visibility), 1, 0), 0, 1);
}

}  // namespace aoscore::testing::published
