#include "published_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

namespace aoscore::testing::published {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

Picture::Picture(const CameraFrame& frame, const GBufferImages& images)
    : surface_(images.surface),
      depth_(images.linear_depth()),
      normal_(images.vector("normal_geometric")),
      smooth_(images.vector("normal_smooth")),
      near_(frame.camera().near),
      far_(frame.camera().far),
      tan_x_(std::tan(frame.camera().fovy_rad / 2) * frame.width() / frame.height()),
      tan_y_(std::tan(frame.camera().fovy_rad / 2)) {}

double Picture::depth(int x, int y) const {
    return static_cast<double>(depth_.at(std::clamp(x, 0, width() - 1), std::clamp(y, 0, height() - 1)));
}

std::vector<double> Picture::depths(int x, int y) const {
    if (layers_.empty()) return {depth(x, y)};
    std::vector<double> all;
    for (const ImageF& layer : layers_) all.push_back(static_cast<double>(layer.at(x, y)));
    return all;
}

bool Picture::surface(int x, int y) const {
    return surface_.at(std::clamp(x, 0, width() - 1), std::clamp(y, 0, height() - 1)) != 0;
}

dvec3 Picture::normal(int x, int y) const {
    return dvec3(normal_.at(std::clamp(x, 0, width() - 1), std::clamp(y, 0, height() - 1)));
}

dvec3 Picture::smooth_normal(int x, int y) const {
    return dvec3(smooth_.at(std::clamp(x, 0, width() - 1), std::clamp(y, 0, height() - 1)));
}

dvec3 Picture::point(double x, double y, double depth) const {
    return {(2 * x / width() - 1) * tan_x_ * depth, (1 - 2 * y / height()) * tan_y_ * depth, -depth};
}

dvec2 Picture::place(const dvec3& p) const {
    return {(p.x / (-p.z * tan_x_) + 1) / 2 * width(), (1 - p.y / (-p.z * tan_y_)) / 2 * height()};
}

dvec3 Picture::face_normal(int x, int y) const {
    const dvec3 p = point(x, y);
    const dvec3 along = x + 1 < width() ? point(x + 1, y) - p : p - point(x - 1, y);
    const dvec3 down = y + 1 < height() ? point(x, y + 1) - p : p - point(x, y - 1);
    const dvec3 n = glm::normalize(glm::cross(down, along));
    return glm::dot(n, p) > 0 ? -n : n;
}

dvec3 Picture::normal_from_depth(int x, int y) const {
    const dvec3 centre = point(x, y);
    const auto edge = [&](int dx, int dy) {
        // 1/z is linear over a plane.
        const auto inverse = [&](int steps) { return 1 / depth(x + steps * dx, y + steps * dy); };
        const auto misses = [&](int side) {
            return std::abs(2 * inverse(side) - inverse(2 * side) - inverse(0));
        };
        const bool can_ahead = x + 2 * dx < width() && y + 2 * dy < height();
        const bool can_behind = x - 2 * dx >= 0 && y - 2 * dy >= 0;
        const bool ahead = can_ahead && (!can_behind || misses(1) < misses(-1));
        return ahead ? point(x + dx, y + dy) - centre : centre - point(x - dx, y - dy);
    };
    const dvec3 n = glm::normalize(glm::cross(edge(1, 0), edge(0, 1)));
    return glm::dot(n, centre) > 0 ? -n : n;
}

DepthLevels::DepthLevels(const Picture& picture, const Reduce& reduce) {
    levels_.emplace_back(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            levels_[0].at(x, y) = static_cast<float>(picture.depth(x, y));
    }
    for (int level = 1; level < 6; ++level) {
        const ImageF& finer = levels_.back();
        ImageF coarser(std::max(finer.width / 2, 1), std::max(finer.height / 2, 1));
        for (int y = 0; y < coarser.height; ++y) {
            for (int x = 0; x < coarser.width; ++x) {
                double four[4];
                for (int i = 0; i < 4; ++i) {
                    four[i] = static_cast<double>(finer.at(std::min(2 * x + i % 2, finer.width - 1),
                                                           std::min(2 * y + i / 2, finer.height - 1)));
                }
                coarser.at(x, y) = static_cast<float>(reduce(four, x, y));
            }
        }
        levels_.push_back(std::move(coarser));
    }
}

double DepthLevels::depth(int level, int x, int y) const {
    const ImageF& image = levels_[static_cast<std::size_t>(level)];
    const int inside_x = std::clamp(x, 0, levels_[0].width - 1),
              inside_y = std::clamp(y, 0, levels_[0].height - 1);
    return static_cast<double>(image.at(std::min(inside_x >> level, image.width - 1),
                                        std::min(inside_y >> level, image.height - 1)));
}

double rotated_pick(const double (&four)[4], int x, int y) {
    return four[(y % 2 == 0 ? 1 : 0) + 2 * (x % 2 == 0 ? 1 : 0)];
}

double farthest_mean(const double (&four)[4], double reach) {
    const double farthest = *std::max_element(four, four + 4);
    double sum = 0, weights = 0;
    for (const double d : four) {
        const double weight = std::clamp((reach - (farthest - d)) / (0.615 * reach), 0.0, 1.0);
        sum += weight * d;
        weights += weight;
    }
    return sum / weights;
}

double clamped(const ImageF& image, int x, int y) {
    return static_cast<double>(
        image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1)));
}

double bilinear(const ImageF& image, const dvec2& at) {
    const double x = at.x - 0.5, y = at.y - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    return std::lerp(std::lerp(clamped(image, i, j), clamped(image, i + 1, j), x - i),
                     std::lerp(clamped(image, i, j + 1), clamped(image, i + 1, j + 1), x - i), y - j);
}

Noise hash_noise(std::uint64_t seed, std::uint32_t stream) {
    return [seed, stream](int px, int py) {
        std::array<std::uint32_t, 4> v = {static_cast<std::uint32_t>(px), static_cast<std::uint32_t>(py),
                                          static_cast<std::uint32_t>(seed), stream};
        const auto stir = [&] {
            v[0] += v[1] * v[3];
            v[1] += v[2] * v[0];
            v[2] += v[0] * v[1];
            v[3] += v[1] * v[2];
        };
        for (std::uint32_t& lane : v) lane = lane * 1664525U + 1013904223U;
        stir();
        for (std::uint32_t& lane : v) lane ^= lane >> 16;
        stir();
        const auto unit = [&](std::size_t i) { return (v[i] >> 8) / 16777216.0; };
        return dvec4(unit(0), unit(1), unit(2), unit(3));
    };
}

namespace {

// The cells of a Hilbert curve of `order` in the square at `corner` that the arms span, in the curve's order:
// four smaller curves, the first along the other arm, the last backward.
void trace_hilbert(dvec2 corner, dvec2 arm, dvec2 other, int order, std::vector<dvec2>& cells) {
    if (order == 0) {
        cells.push_back(corner + (arm + other) / 2.0);
        return;
    }
    const dvec2 a = arm / 2.0, b = other / 2.0;
    trace_hilbert(corner, b, a, order - 1, cells);
    trace_hilbert(corner + a, a, b, order - 1, cells);
    trace_hilbert(corner + a + b, a, b, order - 1, cells);
    trace_hilbert(corner + a + other, -b, -a, order - 1, cells);
}

}  // namespace

Noise hilbert_noise() {
    constexpr int kSide = 64;
    std::vector<dvec2> cells;
    trace_hilbert({0, 0}, {0, kSide}, {kSide, 0}, 6, cells);
    std::vector<int> places(kSide * kSide);
    for (std::size_t i = 0; i < cells.size(); ++i)
        places[static_cast<std::size_t>(std::floor(cells[i].y) * kSide + std::floor(cells[i].x))] =
            static_cast<int>(i);
    return [places](int x, int y) {
        const double i = places[static_cast<std::size_t>(y % kSide * kSide + x % kSide)];
        // The root of x^3 = x + 1 gives both steps.
        constexpr double kPlastic = 1.32471795724474602596;
        const double first = 0.5 + i / kPlastic, second = 0.5 + i / (kPlastic * kPlastic);
        return dvec4(first - std::floor(first), second - std::floor(second), 0, 0);
    };
}

Noise tiled_noise(std::uint64_t seed) {
    return [tile = generate_noise_4x4(seed)](int x, int y) { return dvec4(tile.at(x % 4, y % 4)); };
}

Kernel3 points_of(const Kernel& kernel, std::uint64_t seed) {
    Kernel3 points;
    for (const glm::vec3& p : generate_kernel(kernel, seed)) points.emplace_back(p);
    return points;
}

Numbers sample_numbers(int samples, std::uint64_t seed) {
    Numbers numbers;
    const Kernel kernel{"numbers", std::to_string(samples), "disc", "uniform", "none", "random"};
    for (const dvec3& p : points_of(kernel, seed)) {
        const double turns = std::atan2(p.y, p.x) / (2 * std::numbers::pi);
        numbers.emplace_back(std::hypot(p.x, p.y), turns);
    }
    return numbers;
}

}  // namespace aoscore::testing::published
