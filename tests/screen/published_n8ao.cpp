#include "published_methods.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTau = 2 * std::numbers::pi;

double fraction(double v) {
    return v - std::floor(v);
}

struct N8ao {
    const Picture& picture;
    DepthLevels levels;
    Noise noise;
    double radius;
    bool normals_from_depth;

    static constexpr int kSamples = 16;

    // The frame's second axis is the world's upward one, made perpendicular to n.
    static dvec3 to_view(const dvec3& n, const dvec3& local) {
        dvec3 up(0, 1, 0);
        if (glm::dot(up, n) > 0.99) up = {1, 0, 0};
        const dvec3 side = glm::normalize(glm::cross(up, n));
        return side * local.x + glm::cross(n, side) * local.y + n * local.z;
    }

    double operator()(int px, int py) const {
        const dvec3 p = picture.point(px, py);
        const dvec3 n = normals_from_depth ? picture.normal_from_depth(px, py) : picture.normal(px, py);
        const glm::dvec4 xi = noise(px, py);
        double hidden = 0, counted = 0;
        for (int i = 0; i < kSamples; ++i) {
            // The sunflower's disc is raised to the hemisphere, and turned backward by the noise.
            const double r = std::sqrt((i + 0.5) / kSamples), angle = 2.399963 * i - kTau * xi.x;
            const dvec3 local(r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - r * r));
            const dvec3 s = p + radius * fraction(xi.y + i / double{kSamples}) * to_view(n, local);
            const dvec2 at = picture.place(s);
            const bool inside = -s.z > picture.near() && -s.z < picture.far() && at.x > 0 && at.y > 0 &&
                                at.x < picture.width() && at.y < picture.height();
            if (!inside) continue;
            ++counted;
            const double away = glm::length(at - dvec2(px + 0.5, py + 0.5));
            const int level =
                std::clamp(static_cast<int>(std::floor(std::log2(std::max(away, 1.0)))) - 4, 0, 5);
            const int tx = static_cast<int>(std::floor(at.x)), ty = static_cast<int>(std::floor(at.y));
            const double surface = levels.depth(level, tx, ty);
            // The distance runs from the pixel's centre to the corner of the tap's texel; rows count from
            // below.
            const double dx = px + 0.5 - tx;
            const double dy = (picture.height() - 1 - py) + 0.5 - (picture.height() - 1 - ty);
            if (dx * dx + dy * dy < 1 || surface == picture.depth(px, py) || surface >= -s.z) continue;
            const double t = std::min(0.2 * radius / std::abs(surface + s.z), 1.0);
            hidden += t * t * (3 - 2 * t);
        }
        return counted > 0 ? 1 - hidden / counted : 1;
    }
};

double disc_mean(const Picture& picture, const ImageF& image, double radius, double turn, int px, int py) {
    const dvec3 p = picture.point(px, py), n = picture.normal_from_depth(px, py);
    double sum = static_cast<double>(image.at(px, py)), weights = 1;
    for (int i = 0; i < 8; ++i) {
        const double angle = kTau * (11 * i / 8.0), r = 12 * std::pow((i + 1) / 8.0, 0.75);
        // The disc is turned in the picture, whose rows run down; its own rows run up.
        const dvec2 disc(r * std::cos(angle), -r * std::sin(angle));
        const dvec2 at(px + 0.5 + std::cos(turn) * disc.x - std::sin(turn) * disc.y,
                       py + 0.5 + std::sin(turn) * disc.x + std::cos(turn) * disc.y);
        const int tx = static_cast<int>(std::floor(at.x)), ty = static_cast<int>(std::floor(at.y));
        if (!picture.surface(tx, ty)) continue;
        const int ix = std::clamp(tx, 0, picture.width() - 1), iy = std::clamp(ty, 0, picture.height() - 1);
        const double beside = std::abs(glm::dot(picture.point(at.x, at.y, picture.depth(tx, ty)) - p, n));
        const double weight = std::exp(-beside / (0.2 * radius)) *
                              std::max(glm::dot(n, picture.normal_from_depth(ix, iy)), 0.0);
        sum += weight * bilinear(image, at);
        weights += weight;
    }
    return sum / weights == 0 ? 1 : sum / weights;
}

ImageF turned_means(const Picture& picture, const Noise& noise, const ImageF& image, double radius,
                    int channel) {
    ImageF result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!picture.surface(x, y)) continue;
            result.at(x, y) =
                static_cast<float>(disc_mean(picture, image, radius, kTau * noise(x, y)[channel], x, y));
        }
    }
    return result;
}

}  // namespace

Estimator n8ao(const Picture& picture, const Noise& noise, double radius, bool normals_from_depth) {
    return N8ao{picture, DepthLevels(picture, rotated_pick), noise, radius, normals_from_depth};
}

ImageF n8ao_denoised(const Picture& picture, const Noise& noise, const ImageF& visibility, double radius) {
    ImageF result =
        turned_means(picture, noise, turned_means(picture, noise, visibility, radius, 3), radius, 2);
    for (float& v : result.pixels) v = std::pow(v, 5.0F);
    return result;
}

}  // namespace aoscore::testing::published
