// Unity's SSAO and its bilateral filter.
#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::ivec2;

constexpr double kIntensity = 3, kContrast = 0.6, kBeta = 0.004, kEpsilon = 1e-4, kFalloff = 100;

double fraction(double x) {
    return x - std::floor(x);
}

// The point of the unit sphere for a height and a turn in [0,1).
dvec3 on_sphere(double height, double turns) {
    const double z = 2 * height - 1, r = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * turns;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

// The obscurance by the surface at the pixel of a point of space.
double obscurance(const Picture& picture, const dvec3& p, const dvec3& n, const dvec3& s, double reach) {
    const dvec2 place = picture.place(s);
    const dvec2 inside(std::clamp(place.x, 0.0, 1.0 * picture.width()),
                       std::clamp(place.y, 0.0, 1.0 * picture.height()));
    const int x = static_cast<int>(std::floor(inside.x)), y = static_cast<int>(std::floor(inside.y));
    const double depth = picture.depth(x, y);
    if (!picture.surface(x, y) || std::abs(-s.z - depth) >= reach) return 0;
    const dvec3 v = picture.point(inside.x, inside.y, depth) - p;
    return std::max(glm::dot(v, n) + kBeta * p.z, 0.0) / (glm::dot(v, v) + kEpsilon);
}

// Makes an estimator; `sample` gives a point in the unit ball for a pixel and an index.
Estimator estimator(const Picture& picture, int samples, double reach,
                    const std::function<dvec3(int x, int y, int i)>& sample) {
    return [&picture, samples, reach, sample](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.smooth_normal(x, y);
        double sum = 0;
        for (int i = 0; i < samples; ++i) {
            const dvec3 offset = sample(x, y, i);
            const double side = glm::dot(offset, n) < 0 ? -1 : 1;
            sum += obscurance(picture, p, n, p + side * reach * offset, reach);
        }
        const double fade = 1 - -p.z / kFalloff;
        const double dark = std::clamp(sum * reach * kIntensity * fade * fade / samples, 0.0, 1.0);
        return 1 - std::pow(dark, kContrast);
    };
}

dvec3 normal_at(const Picture& picture, const ivec2& at) {
    return picture.surface(at.x, at.y) ? picture.smooth_normal(at.x, at.y) : dvec3(0);
}

struct Mean {
    dvec3 normal;
    double sum = 0, weights = 0;
    void add(double value, const dvec3& other, double weight) {
        const double t = std::clamp((glm::dot(normal, other) - 0.8) / 0.2, 0.0, 1.0);
        sum += value * weight * t * t * (3 - 2 * t);
        weights += weight * t * t * (3 - 2 * t);
    }
};

ImageF filtered(const Picture& picture, const ImageF& image, double centre,
                const std::function<void(Mean&, const ivec2&)>& add_others) {
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            Mean mean{picture.smooth_normal(x, y), centre * static_cast<double>(image.at(x, y)), centre};
            add_others(mean, {x, y});
            result.at(x, y) = static_cast<float>(mean.sum / mean.weights);
        }
    }
    return result;
}

ImageF along(const Picture& picture, const ImageF& image, const ivec2& axis) {
    return filtered(picture, image, 0.227027027, [&](Mean& mean, const ivec2& at) {
        for (const double place : {-3.2307692308, -1.3846153846, 1.3846153846, 3.2307692308}) {
            const int low = static_cast<int>(std::floor(place));
            const double t = place - low;
            const ivec2 a = at + low * axis, b = a + axis;
            mean.add(std::lerp(clamped(image, a.x, a.y), clamped(image, b.x, b.y), t),
                     glm::mix(normal_at(picture, a), normal_at(picture, b), t),
                     std::abs(place) < 2 ? 0.3162162162 : 0.0702702703);
        }
    });
}

}  // namespace

Estimator unity_ssao(const Picture& picture, const Numbers& numbers, std::uint64_t seed, double radius) {
    const int samples = static_cast<int>(numbers.size());
    const auto sample = [numbers, seed, samples](int x, int y, int i) {
        const double noise = hash_noise(seed, static_cast<std::uint32_t>(i))(x, y).x;
        const double part = static_cast<double>(i) / samples;
        const dvec2 own = numbers[static_cast<std::size_t>(i)];
        return std::lerp(0.1, 1.0, part * part) *
               on_sphere(fraction(own.x + noise), fraction(100 * (own.y + noise)));
    };
    return estimator(picture, samples, 1.5 * radius, sample);
}

Estimator unity_gradient_ssao(const Picture& picture, const Numbers& numbers, double radius) {
    const int samples = static_cast<int>(numbers.size()), height = picture.height();
    const auto sample = [numbers, samples, height](int x, int y, int i) {
        // The noise is Jimenez's of 2014; Unity counts rows from below.
        const dvec2 at(x + 0.5 + 2.083 * i, height - y - 0.5 + 4.867 * i);
        const double noise = fraction(52.9829189 * fraction(0.06711056 * at.x + 0.00583715 * at.y));
        const dvec2 own = numbers[static_cast<std::size_t>(i)];
        return std::sqrt((i + 1.0) / samples) * on_sphere(fraction(own.x + noise), own.y + noise);
    };
    return estimator(picture, samples, radius, sample);
}

ImageF unity_blurred(const Picture& picture, const ImageF& visibility) {
    const ImageF both = along(picture, along(picture, visibility, {1, 0}), {0, 1});
    return filtered(picture, both, 1, [&](Mean& mean, const ivec2& at) {
        for (const ivec2 corner : {ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1)}) {
            const ivec2 tap = at + corner;
            mean.add(clamped(both, tap.x, tap.y), normal_at(picture, tap), 1);
        }
    });
}

}  // namespace aoscore::testing::published
