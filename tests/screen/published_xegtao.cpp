#include "published_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;

// Halves the exponent in the bits of a single float, as published; this is no rounding error.
double rough_root(double x) {
    const auto single = static_cast<float>(x);
    std::int32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    bits = 0x1fbd1df5 + (bits >> 1);
    float root = 0;
    std::memcpy(&root, &bits, sizeof root);
    return static_cast<double>(root);
}

double rough_acos(double x) {
    const double angle = (kPi / 2 - 0.156583 * std::abs(x)) * rough_root(1 - std::abs(x));
    return x < 0 ? kPi - angle : angle;
}

struct Xegtao {
    const Picture& picture;
    DepthLevels levels;
    Noise noise;
    double radius;  // includes its multiplier
    int slices, steps;

    // The highest cosine on one side of a slice, `toward` pixels long.
    double horizon(int px, int py, const dvec3& p, const dvec3& view, const dvec2& toward, double low,
                   int slice, double xi) const {
        double highest = low;
        for (int j = 0; j < steps; ++j) {
            const double golden = (slice + j * steps) * (std::numbers::phi - 1), shifted = xi + golden;
            const double s =
                std::pow((j + shifted - std::floor(shifted)) / steps, 2) + 1.3 / glm::length(toward);
            const dvec2 offset = s * toward;
            const double level = std::clamp(std::log2(glm::length(offset)) - 3.3, 0.0, 4.0);
            const int tx = px + static_cast<int>(std::lround(offset.x)),
                      ty = py + static_cast<int>(std::lround(offset.y));
            const dvec3 v = picture.point(tx + 0.5, ty + 0.5,
                                          levels.depth(static_cast<int>(std::lround(level)), tx, ty)) -
                            p;
            const double weight = std::clamp((radius - glm::length(v)) / (0.615 * radius), 0.0, 1.0);
            highest = std::max(highest, std::lerp(low, glm::dot(v, view) / glm::length(v), weight));
        }
        return highest;
    }

    double operator()(int px, int py) const {
        const double depth = picture.depth(px, py) * 0.99999;
        const dvec3 p = picture.point(px + 0.5, py + 0.5, depth), n = picture.normal(px, py);
        const dvec3 view = glm::normalize(-p);
        const double reach = radius * picture.pixels_per_metre(depth);
        const glm::dvec4 xi = noise(px, py);
        double sum = std::clamp((10 - reach) / 100, 0.0, 1.0) * 0.5;
        for (int i = 0; i < slices; ++i) {
            const double phi = (i + xi.x) / slices * kPi;
            const dvec3 direction(std::cos(phi), std::sin(phi), 0);
            const dvec3 along = direction - glm::dot(direction, view) * view;
            const dvec3 axis = glm::normalize(glm::cross(along, view));
            const dvec3 projected = n - axis * glm::dot(n, axis);
            const double length = glm::length(projected);
            const double unsigned_gamma =
                rough_acos(std::clamp(glm::dot(projected, view) / length, 0.0, 1.0));
            const double gamma = glm::dot(along, projected) < 0 ? -unsigned_gamma : unsigned_gamma;
            const dvec2 toward = reach * dvec2(std::cos(phi), -std::sin(phi));  // rows run down
            const double h1 =
                rough_acos(horizon(px, py, p, view, toward, std::cos(gamma + kPi / 2), i, xi.y));
            const double h0 =
                -rough_acos(horizon(px, py, p, view, -toward, std::cos(gamma - kPi / 2), i, xi.y));
            double arcs = 0;
            for (const double h : {h0, h1})
                arcs += (std::cos(gamma) + 2 * h * std::sin(gamma) - std::cos(2 * h - gamma)) / 4;
            sum += std::lerp(length, 1.0, 0.05) * arcs;
        }
        return std::clamp(std::pow(std::max(sum, 0.0) / slices, 2.2), 0.03, 1.5);
    }
};

// The edges to the left, right, above and below, in thirds: 1 is no edge, 0 an edge. Outside of the picture
// the nearest pixel's.
std::array<double, 4> sides(const Picture& picture, int at_x, int at_y) {
    const int x = std::clamp(at_x, 0, picture.width() - 1), y = std::clamp(at_y, 0, picture.height() - 1);
    const double here = picture.depth(x, y);
    std::array<double, 4> step = {picture.depth(x - 1, y) - here, picture.depth(x + 1, y) - here,
                                  picture.depth(x, y - 1) - here, picture.depth(x, y + 1) - here};
    std::array<double, 4> open{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double other = step[i ^ 1U];
        // The mean slope across the pixel is (step to the right - step to the left)/2.
        const double slope = 0.5 * (i % 2 == 0 ? other - step[i] : step[i] - other);
        const double levelled = i % 2 == 0 ? step[i] + slope : step[i] - slope;
        const double edge = std::min(std::abs(step[i]), std::abs(levelled)) / (here * 0.011);
        open[i] = std::round(std::clamp(1.25 - edge, 0.0, 1.0) * 2.9) / 3;
    }
    return open;
}

}  // namespace

Estimator xegtao(const Picture& picture, const Noise& noise, double radius, int slices, int steps) {
    const double whole = 1.457 * radius;
    return Xegtao{picture,
                  DepthLevels(picture, [whole](const double(&four)[4], int,
                                               int) { return farthest_mean(four, 0.75 * whole); }),
                  noise,
                  whole,
                  slices,
                  steps};
}

ImageF xegtao_denoised(const Picture& picture, const ImageF& visibility) {
    ImageF result = visibility;
    const auto value = [&](int x, int y) { return clamped(visibility, x, y); };
    for (int y = 0; y < visibility.height; ++y) {
        for (int x = 0; x < visibility.width; ++x) {
            if (!picture.surface(x, y)) continue;
            const auto left = sides(picture, x - 1, y), right = sides(picture, x + 1, y),
                       above = sides(picture, x, y - 1), below = sides(picture, x, y + 1);
            auto open = sides(picture, x, y);
            const double back[4] = {left[1], right[0], above[3], below[2]};
            double total = 0;
            for (std::size_t i = 0; i < 4; ++i) total += open[i] *= back[i];
            const double leak = std::clamp(4 - 2.5 - total, 0.0, 1.0) / (4 - 2.5) * 0.5;
            for (double& o : open) o = std::min(o + leak, 1.0);
            double sum = 1.2 * value(x, y), weights = 1.2;
            const auto add = [&](int dx, int dy, double weight) {
                sum += weight * value(x + dx, y + dy);
                weights += weight;
            };
            add(-1, 0, open[0]);
            add(1, 0, open[1]);
            add(0, -1, open[2]);
            add(0, 1, open[3]);
            add(-1, -1, 0.425 * (open[0] * left[2] + open[2] * above[0]));
            add(1, -1, 0.425 * (open[2] * above[1] + open[1] * right[2]));
            add(-1, 1, 0.425 * (open[3] * below[0] + open[0] * left[3]));
            add(1, 1, 0.425 * (open[1] * right[3] + open[3] * below[1]));
            result.at(x, y) = static_cast<float>(std::min(sum / weights, 1.0));
        }
    }
    return result;
}

}  // namespace aoscore::testing::published
