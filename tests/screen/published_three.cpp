#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;

// Makes a magic square by the Siamese method: from the middle of the last column it goes up and to the right;
// where that cell is taken, two to the left of it and one down.
std::vector<int> magic_square(int side) {
    std::vector<int> numbers(static_cast<std::size_t>(side * side));
    const auto wrapped = [side](int i) { return (i % side + side) % side; };
    int row = side / 2, column = side - 1;
    for (int number = 1; number <= side * side; ++number) {
        numbers[static_cast<std::size_t>(row * side + column)] = number;
        const int next_row = wrapped(row - 1), next_column = wrapped(column + 1);
        const bool taken = numbers[static_cast<std::size_t>(next_row * side + next_column)] != 0;
        row = taken ? row : next_row;
        column = taken ? wrapped(column - 1) : next_column;
    }
    return numbers;
}

struct ThreeGtao {
    const Picture& picture;
    double radius, thickness;
    std::vector<int> square = magic_square(5);

    double raised(double cosine, const dvec3& p, const dvec3& view, const dvec3& reach) const {
        for (int j = 1; j <= 6; ++j) {
            const dvec2 at = picture.place(p + reach * (j / 6.0));
            const double depth =
                picture.depth(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
            const dvec3 v = picture.point(at.x, at.y, depth) - p;
            if (std::abs(v.z) >= thickness) continue;
            const double higher = glm::dot(view, v) / glm::length(v) - cosine;
            if (higher > 0) cosine += higher * 2 / (j + 1);
        }
        return cosine;
    }

    double operator()(int px, int py) const {
        const dvec3 p = picture.point(px, py), n = picture.smooth_normal(px, py), view = glm::normalize(-p);
        const int row = (picture.height() - 1 - py) % 5;
        const double turn = 2 * kPi * square[static_cast<std::size_t>(row * 5 + px % 5)] / 25;
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            const double azimuth = turn + kPi * i / 3;
            const dvec3 along(std::cos(azimuth), std::sin(azimuth), 0);
            // The slice's plane has a unit vector u to the side of `along`, the view vector, and the normal's
            // angle gamma from the view vector toward u.
            const dvec3 u = glm::normalize(along - view * glm::dot(along, view));
            const double gamma = std::atan2(glm::dot(n, u), glm::dot(n, view));
            const double c0 = raised(std::cos(gamma + kPi / 2), p, view, radius * along);
            const double c1 = raised(std::cos(gamma - kPi / 2), p, view, -radius * along);
            // The integral of cos(t - gamma) |sin t| between the horizons, for a unit normal.
            const double h0 = std::acos(c0), h1 = std::acos(c1);
            const double across = 0.5 * (h0 - std::sin(h0) * c0 - (h1 - std::sin(h1) * c1));
            sum += std::cos(gamma) * 0.5 * (2 - c0 * c0 - c1 * c1) + std::sin(gamma) * across;
        }
        return std::clamp(sum / 3, 0.0, 1.0);
    }
};

}  // namespace

Estimator three_gtao(const Picture& picture, double radius, double thickness) {
    return ThreeGtao{picture, radius, thickness};
}

ImageF three_denoised(const Picture& picture, const Noise& noise, const ImageF& visibility,
                      double depth_phi) {
    ImageF result = visibility;
    for (int y = 0; y < visibility.height; ++y) {
        for (int x = 0; x < visibility.width; ++x) {
            if (!picture.surface(x, y)) continue;
            const dvec3 p = picture.point(x, y), n = picture.smooth_normal(x, y);
            const double turn = 2 * kPi * noise(x, y).x, s = std::sin(turn), c = std::cos(turn);
            const auto centre = static_cast<double>(visibility.at(x, y));
            double sum = centre, weights = 1;
            for (int i = 0; i < 16; ++i) {
                const double angle = 2 * kPi * 2 * i / 16, length = 1 + 7 * (i / 15.0);
                const dvec2 tap(length * std::cos(angle), length * std::sin(angle));
                const dvec2 at(x + 0.5 + s * (tap.x + tap.y), y + 0.5 - c * (tap.y - tap.x));
                const int tx = static_cast<int>(std::floor(at.x)), ty = static_cast<int>(std::floor(at.y));
                if (!picture.surface(tx, ty)) continue;
                const double value = bilinear(visibility, at);
                const double beside =
                    std::abs(glm::dot(p - picture.point(at.x, at.y, picture.depth(tx, ty)), n));
                const double weight = std::max(1 - std::abs(value - centre) / 10, 0.0) *
                                      std::max(1 - beside / depth_phi, 0.0) *
                                      std::pow(std::max(glm::dot(n, picture.smooth_normal(tx, ty)), 0.0), 3);
                sum += weight * value;
                weights += weight;
            }
            result.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return result;
}

}  // namespace aoscore::testing::published
