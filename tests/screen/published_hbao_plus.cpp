#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

// One of the sixteen pictures of every fourth pixel, and a pixel of it.
struct Interleaved {
    const Picture& picture;
    int column, row;  // place of the first pixel

    dvec3 point(int i, int j) const {
        const int last_i = (picture.width() - 1 - column) / 4, last_j = (picture.height() - 1 - row) / 4;
        const double depth =
            picture.depth(column + 4 * std::clamp(i, 0, last_i), row + 4 * std::clamp(j, 0, last_j));
        return picture.point(column + 4 * i + 0.5, row + 4 * j + 0.5, depth);
    }
};

double estimate(const Picture& picture, const Noise& noise, double radius, int px, int py) {
    const Interleaved quarter{picture, px % 4, py % 4};
    const dvec3 p = picture.point(px, py), n = picture.normal(px, py);
    const double reach = radius * picture.pixels_per_metre(-p.z);
    if (reach < 1) return 1;
    const glm::dvec4 xi = noise(px, py);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const double angle = (i + xi.x) * 2 * std::numbers::pi / 8;
        const dvec2 direction(std::cos(angle), std::sin(angle));
        for (int j = 0; j < 4; ++j) {
            const double away = 1 + (xi.y + j) * (reach / 4 / 5);
            const dvec3 v = quarter.point(px / 4 + static_cast<int>(std::lround(away * direction.x)),
                                          py / 4 + static_cast<int>(std::lround(away * direction.y))) -
                            p;
            const double falloff = std::clamp(1 - glm::dot(v, v) / (radius * radius), 0.0, 1.0);
            const double above = std::max(glm::dot(n, v) / glm::length(v) - 0.1, 0.0);
            sum += (j == 0 ? 2 : 1) * falloff * above / 0.9;
        }
    }
    return std::clamp(1 - 2 * sum / 32, 0.0, 1.0);
}

// Filters along a row or column, by values and depths.
ImageF blurred(const Picture& picture, const ImageF& image, int dx, int dy) {
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            const double here = picture.depth(x, y);
            const auto value = [&](int i) { return clamped(image, x + i * dx, y + i * dy); };
            const auto depth = [&](int i) { return picture.depth(x + i * dx, y + i * dy); };
            double sum = value(0), weights = 1;
            const auto add = [&](int i, double v, double d, double slope) {
                const double apart = (d - slope * std::abs(i) - here) * 16;
                const double weight = std::exp2(-i * i / (2 * 2.5 * 2.5) - apart * apart);
                sum += weight * v;
                weights += weight;
            };
            for (const int side : {1, -1}) {
                const double slope = depth(side) - here;
                add(side, value(side), depth(side), slope);
                add(2 * side, value(2 * side), depth(2 * side), slope);
                add(3 * side, (value(3 * side) + value(4 * side)) / 2,
                    (depth(3 * side) + depth(4 * side)) / 2, slope);
            }
            result.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return result;
}

}  // namespace

Estimator hbao_plus(const Picture& picture, const Noise& noise, double radius) {
    return [&picture, noise, radius](int x, int y) { return estimate(picture, noise, radius, x, y); };
}

ImageF hbao_plus_blurred(const Picture& picture, const ImageF& visibility) {
    ImageF result = blurred(picture, blurred(picture, visibility, 1, 0), 0, 1);
    for (float& v : result.pixels) v *= v;
    return result;
}

}  // namespace aoscore::testing::published
