#include "published_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

// Offsets to the left, right, above and below, in pictures of every second pixel.
constexpr int kSides[4][2] = {{-2, 0}, {2, 0}, {0, -2}, {0, 2}};

std::array<double, 4> edges(const Picture& picture, int x, int y, bool by_normals = true) {
    const double here = picture.depth(x, y);
    std::array<double, 4> step{}, open{};
    for (std::size_t i = 0; i < 4; ++i) step[i] = picture.depth(x + kSides[i][0], y + kSides[i][1]) - here;
    for (std::size_t i = 0; i < 4; ++i) {
        const double level = std::min(std::abs(step[i]), std::abs(step[i] + step[i ^ 1U]));
        const double facing =
            by_normals
                ? glm::dot(picture.normal(x, y), picture.normal(x + kSides[i][0], y + kSides[i][1])) + 0.5
                : 1;
        open[i] = std::clamp(1.3 - level / (0.04 * here), 0.0, 1.0) * std::clamp(facing, 0.0, 1.0);
    }
    return open;
}

double obscurance(const dvec3& v, const dvec3& n, double radius) {
    const double d2 = glm::dot(v, v);
    return std::max(glm::dot(v, n) / std::sqrt(d2) - 0.06, 0.0) * std::max(1 - d2 / (radius * radius), 0.0);
}

struct Assao {
    bool is_godot;
    const Picture& picture;
    DepthLevels levels;
    std::vector<dvec2> pattern;
    double radius, tan_half;

    // Turns a place by quarter turns and mirrors it, in one of five ways in each of the four pictures.
    static dvec2 turned(const dvec2& place, int px, int py) {
        constexpr int kOrder[] = {0, 1, 4, 3, 2};
        const int pass = px % 2 + 2 * (py % 2), part = kOrder[(py / 2 * 2 + px / 2) % 5];
        const double angle = (pass + part / 5.0) * std::numbers::pi / 2;
        const double scale = 1 + (pass - 1.5 + (part - 2) / 5.0) * 0.07;
        return scale * dvec2(std::cos(angle) * place.x - std::sin(angle) * place.y,
                             -std::sin(angle) * place.x - std::cos(angle) * place.y);
    }

    double operator()(int px, int py) const {
        const dvec3 n = picture.normal(px, py);
        dvec3 p = picture.point(px, py) * (is_godot ? 1 : 0.9992);
        const double near = std::clamp(glm::length(p) * tan_half / (1.2 * radius), 0.0, 1.0) * 0.8 + 0.2;
        const double reach = radius * near, pixels_per_metre = picture.pixels_per_metre(-p.z);
        const auto open = edges(picture, px, py, !is_godot);
        double sum = 0, weights = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const int x = px + kSides[i][0], y = py + kSides[i][1];
            const dvec3 v = picture.point(x + 0.5, y + 0.5, picture.depth(x, y)) - p;
            sum += 0.5 * open[i] * obscurance(v, n, reach / 2);
        }
        // Godot then moves only the depth nearer.
        if (is_godot) p.z *= 0.99;
        const double u = (px + 0.5) / picture.width(), v = (py + 0.5) / picture.height();
        const double inward = 10 * std::min({u, 1 - u, v, 1 - v}) + 0.6,
                     border = is_godot ? std::min(inward, 1.0) : 1;
        const double disc = border * 0.85 * reach * pixels_per_metre;
        for (const dvec2& place : pattern) {
            const dvec2 offset = turned(place, px, py) * (disc / 2);
            const int level = static_cast<int>(
                std::lround(is_godot ? 0 : std::clamp(std::log2(glm::length(offset)) - 4.3, 0.0, 3.0)));
            for (const int side : {1, -1}) {
                const int x = px + 2 * side * static_cast<int>(std::lround(offset.x)),
                          y = py + 2 * side * static_cast<int>(std::lround(offset.y));
                const double depth = level == 0 ? picture.depth(x, y) : levels.depth(level + 1, x, y);
                const dvec3 to_tap = picture.point(x + 0.5, y + 0.5, depth) - p;
                const double weight = 0.4 + 0.6 * std::clamp(2 - std::max(to_tap.z, 0.0) / radius, 0.0, 1.0);
                sum += weight * obscurance(to_tap, n, reach);
                weights += weight;
            }
        }
        const double distance_fade = std::clamp((300 + p.z) / (300 - 50), 0.0, 1.0);
        const double thin = std::clamp((1 - open[0] - open[1]) * 0.35, 0.0, 1.0) +
                            std::clamp((1 - open[2] - open[3]) * 0.35, 0.0, 1.0);
        const double strength =
            std::min((is_godot ? 2 : 4.3) * sum / weights, 0.98) * distance_fade * std::max(1 - thin, 0.0);
        return std::pow(1 - strength, 1.5);
    }
};

std::array<double, 4> stored(const Picture& picture, int x, int y) {
    auto open = edges(picture, x, y);
    for (double& o : open) o = std::min(std::round(o * 3.05) / 3 + 0.02, 1.0);
    return open;
}

Assao assao(bool is_godot, const Picture& picture, const std::vector<dvec2>& pattern, double radius,
            double tan_half) {
    const auto reduce = [radius](const double(&four)[4], int, int) {
        return farthest_mean(four, 0.75 * 1.457 * radius);
    };
    return Assao{is_godot, picture, DepthLevels(picture, reduce), pattern, radius, tan_half};
}

}  // namespace

Estimator cacao(const Picture& picture, const std::vector<dvec2>& pattern, double radius, double tan_half) {
    return assao(false, picture, pattern, radius, tan_half);
}

Estimator godot_ssao(const Picture& picture, const std::vector<dvec2>& pattern, double radius,
                     double tan_half) {
    return assao(true, picture, pattern, radius, tan_half);
}

ImageF cacao_blurred(const Picture& picture, const ImageF& visibility) {
    ImageF image = visibility;
    for (int turn = 0; turn < 3; ++turn) {
        const ImageF before = image;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (!picture.surface(x, y)) continue;
                const auto open = stored(picture, x, y);
                if (turn < 2) {
                    double sum = 0.5 * clamped(before, x, y), weights = 0.5;
                    for (std::size_t i = 0; i < 4; ++i) {
                        sum += open[i] * clamped(before, x + kSides[i][0], y + kSides[i][1]);
                        weights += open[i];
                    }
                    image.at(x, y) = static_cast<float>(sum / weights);
                    continue;
                }
                // The value of the picture of every second pixel that begins at (cx, cy), at a place in the
                // whole picture.
                const auto other = [&](int cx, int cy, double at_x, double at_y) {
                    const double u = at_x / 2 - 0.5, v = at_y / 2 - 0.5;
                    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
                    const auto pixel = [&](int a, int b) { return clamped(before, 2 * a + cx, 2 * b + cy); };
                    return std::lerp(std::lerp(pixel(i, j), pixel(i + 1, j), u - i),
                                     std::lerp(pixel(i, j + 1), pixel(i + 1, j + 1), u - i), v - j);
                };
                const int mx = x % 2, my = y % 2;
                const double push_x = open[1] - open[0], push_y = open[3] - open[2];
                const double beside = other(1 - mx, my, x + mx + push_x - 0.5, y + 0.5 - my);
                const double above = other(mx, 1 - my, x + 0.5 - mx, y + my - 0.5 + push_y);
                const double across = other(1 - mx, 1 - my, x + mx - 0.5 + push_x, y + my - 0.5 + push_y);
                const double h = (open[0] + open[1]) / 2, v = (open[2] + open[3]) / 2, d = (h + v) / 2;
                image.at(x, y) = static_cast<float>(
                    (clamped(before, x, y) + h * beside + v * above + d * across) / (1 + h + v + d));
            }
        }
    }
    return image;
}

}  // namespace aoscore::testing::published
