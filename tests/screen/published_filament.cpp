#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTau = 2 * std::numbers::pi;

struct Filament {
    const Picture& picture;
    DepthLevels levels;
    double radius;

    double operator()(int px, int py) const {
        const dvec3 p = picture.point(px, py), n = picture.normal_from_depth(px, py);
        const double at = 0.06711056 * (px + 0.5) + 0.00583715 * (py + 0.5);
        const double inner = 52.9829189 * (at - std::floor(at)), noise = inner - std::floor(inner);
        const double disc = radius * picture.pixels_per_metre(-p.z), peak = 0.1 * radius;
        double sum = 0;
        for (int i = 0; i < 7; ++i) {
            const double angle = i / 6.5 * 3 * kTau + 2.4 * kTau * noise;
            const double away = std::max(1.0, std::pow((i + noise + 0.5) / 6.5, 2) * disc);
            // Rows of the picture run down.
            const dvec2 place(px + 0.5 + away * std::cos(angle), py + 0.5 - away * std::sin(angle));
            const int level = std::clamp(static_cast<int>(std::floor(std::log2(away))) - 3, 0, 5);
            const double depth = levels.depth(level, static_cast<int>(std::floor(place.x)),
                                              static_cast<int>(std::floor(place.y)));
            const dvec3 v = picture.point(place.x, place.y, depth) - p;
            const double vv = glm::dot(v, v), w = std::pow(std::max(0.0, 1 - vv / (radius * radius)), 2);
            sum += w * std::max(0.0, glm::dot(v, n) + p.z * 0.0005) / (vv + peak * peak);
        }
        const double occlusion = std::sqrt(sum * kTau * peak / 7);
        return std::pow(std::clamp(1 - occlusion, 0.0, 1.0), 2);
    }
};

ImageF blurred(const Picture& picture, const ImageF& image, int dx, int dy) {
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            double sum = 0, weights = 0;
            for (int i = -5; i <= 5; ++i) {
                const int tx = x + 2 * i * dx, ty = y + 2 * i * dy;
                const double apart = (picture.depth(tx, ty) - picture.depth(x, y)) / 0.05;
                const double weight = std::exp(-i * i / 32.0) * std::max(0.0, 1 - apart * apart);
                sum += weight * clamped(image, tx, ty);
                weights += weight;
            }
            result.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return result;
}

}  // namespace

Estimator filament_ssao(const Picture& picture, double radius) {
    return Filament{picture, DepthLevels(picture, rotated_pick), radius};
}

ImageF filament_blurred(const Picture& picture, const ImageF& visibility) {
    return blurred(picture, blurred(picture, visibility, 1, 0), 0, 1);
}

}  // namespace aoscore::testing::published
