// HBAO and its filter as in NVIDIA's Direct3D SDK 11. Its view space has the depth as z, and rows run down.
#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::ivec2;

constexpr int kDirections = 8;
constexpr double kSteps = 6;
const double kTangentBias = std::tan(10 * std::numbers::pi / 180);

// The sine of an elevation from its tangent.
double sine(double tangent) {
    return tangent / std::sqrt(1 + tangent * tangent);
}

struct March {
    const Picture& picture;
    double radius;
    ivec2 pixel;
    dvec3 p, right, down;  // the pixel's point; steps to its neighbours on the tangent plane
    double step, count, jitter;

    dvec3 surface(const ivec2& offset) const {
        const ivec2 at = pixel + offset;
        return picture.point(at.x + 0.5, at.y + 0.5, picture.depth(at.x, at.y));
    }
    static std::optional<double> elevation(const dvec3& v) {
        const double along = std::hypot(v.x, v.y);
        return along > 0 ? std::optional(v.z / along) : std::nullopt;
    }
    std::optional<double> tangent(const ivec2& offset) const {
        const auto plane =
            elevation(static_cast<double>(offset.x) * right + static_cast<double>(offset.y) * down);
        return plane ? std::optional(*plane + kTangentBias) : std::nullopt;
    }
    // The occlusion that a tap adds over `low`; raises the horizon to the tap.
    double rise(const dvec3& v, std::optional<double> low, std::optional<double>& horizon) const {
        const auto top = elevation(v);
        const double part = glm::dot(v, v) / (radius * radius);
        if (!top || !low || part >= 1 || *top <= *low) return 0;
        horizon = horizon ? std::max(*horizon, *top) : *top;
        return (1 - part) * (sine(*top) - sine(*low));
    }
    static ivec2 whole(const dvec2& offset) {
        return {static_cast<int>(std::lround(offset.x)), static_cast<int>(std::lround(offset.y))};
    }
    double along(const dvec2& direction) const {
        const ivec2 stride = whole(step * direction), start = whole(jitter * step * direction);
        std::optional<double> horizon = tangent(stride);
        const ivec2 first = whole(jitter * dvec2(stride) + direction);
        double sum = rise(surface(first) - p, tangent(first), horizon);
        for (int j = 1; j <= count - 1; ++j) sum += rise(surface(start + j * stride) - p, horizon, horizon);
        return sum;
    }
};

dvec3 nearer(const dvec3& ahead, const dvec3& behind) {
    return glm::dot(ahead, ahead) < glm::dot(behind, behind) ? ahead : behind;
}

double estimate(const Picture& picture, const Noise& noise, double radius, int x, int y) {
    March march{picture, radius, {x, y}, picture.point(x, y), {}, {}, 0, 0, 0};
    const double reach = radius * picture.pixels_per_metre(-march.p.z);
    if (reach < 1) return 1;
    const glm::dvec4 xi = noise(x, y);
    march.jitter = xi.y;
    march.count = std::min(kSteps, reach);
    march.step = reach / (march.count + 1);
    const double longest = 0.1 * std::min(picture.width(), picture.height());
    if (longest / march.step < march.count) {
        march.count = std::max(std::floor(longest / march.step + xi.y), 1.0);
        march.step = longest / march.count;
    }
    march.right = nearer(march.surface({1, 0}) - march.p, march.p - march.surface({-1, 0}));
    march.down = nearer(march.surface({0, 1}) - march.p, march.p - march.surface({0, -1}));
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = (i + xi.x) * 2 * std::numbers::pi / kDirections;
        sum += march.along({std::cos(angle), std::sin(angle)});
    }
    return std::max(0.0, 1 - sum / kDirections);
}

ImageF blurred(const Picture& picture, const ImageF& image, const ivec2& axis, double depth_step) {
    constexpr double kSigma = 8.5;
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            double sum = static_cast<double>(image.at(x, y)), weights = 1;
            for (int r = -15; r <= 15; r += 2) {
                // Interpolates between the pixels on both sides of ±1.5, ±3.5, …
                const int near = r < 0 ? r - 1 : r, far = near + 1;
                const ivec2 a = ivec2(x, y) + near * axis, b = ivec2(x, y) + far * axis;
                const double at = (near + far) / 2.0;
                const double depth = (picture.depth(a.x, a.y) + picture.depth(b.x, b.y)) / 2;
                if (std::abs(depth - picture.depth(x, y)) >= depth_step) continue;
                const double weight = std::exp(-at * at / (2 * kSigma * kSigma));
                sum += weight * (clamped(image, a.x, a.y) + clamped(image, b.x, b.y)) / 2;
                weights += weight;
            }
            result.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return result;
}

}  // namespace

Estimator nvidia_hbao(const Picture& picture, const Noise& noise, double radius) {
    return [&picture, noise, radius](int x, int y) { return estimate(picture, noise, radius, x, y); };
}

ImageF nvidia_hbao_blurred(const Picture& picture, const ImageF& visibility) {
    // The sharpness is 8 for a scene whose unit is the radius.
    const double depth_step = 2 * std::sqrt(std::numbers::ln2) / 8;
    return blurred(picture, blurred(picture, visibility, {1, 0}, depth_step), {0, 1}, depth_step);
}

}  // namespace aoscore::testing::published
