// Methods that test points of space against the depth buffer, as the programs of their sources do.
#include "published_methods.h"

#include <cmath>
#include <functional>

namespace aoscore::testing::published {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kBias = 0.025;

// The view z of the surface at a point's pixel; outside of the picture that of its edge, or the background's.
double surface_z(const Picture& picture, const dvec3& point, bool at_edge) {
    const dvec2 place = picture.place(point);
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    const bool inside = x >= 0 && y >= 0 && x < picture.width() && y < picture.height();
    return inside || at_edge ? -picture.depth(x, y) : -picture.far();
}

dvec3 tile_vector(const Noise& noise, int x, int y) {
    const glm::dvec4 xi = noise(x, y);
    return {2 * xi.x - 1, 2 * xi.y - 1, 0};
}

glm::dmat3 frame_of(const dvec3& tangent, const dvec3& normal) {
    return {tangent, glm::cross(normal, tangent), normal};
}

dvec3 across(const dvec3& vector, const dvec3& normal) {
    return vector - normal * glm::dot(vector, normal);
}

// 1 less the mean of `hidden` over the kernel's points at `position`.
double open_part(const Kernel3& kernel, const std::function<double(const dvec3& point)>& hidden) {
    double sum = 0;
    for (const dvec3& k : kernel) sum += hidden(k);
    return 1 - sum / static_cast<double>(kernel.size());
}

}  // namespace

Estimator learnopengl_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius) {
    return [&picture, kernel, noise, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.smooth_normal(x, y);
        const glm::dmat3 frame = frame_of(glm::normalize(across(tile_vector(noise, x, y), n)), n);
        return open_part(kernel, [&](const dvec3& k) {
            const dvec3 s = p + frame * k * radius;
            const double z = surface_z(picture, s, true);
            const double t = std::min(radius / std::abs(p.z - z), 1.0);
            return z >= s.z + kBias ? t * t * (3 - 2 * t) : 0.0;
        });
    };
}

Estimator hussain_crytek(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius) {
    return [&picture, kernel, noise, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.face_normal(x, y);
        const dvec3 random = tile_vector(noise, x, y), plane = random - 1.0;
        const glm::dmat3 frame = frame_of(glm::normalize(across(random, n)), n);
        return open_part(kernel, [&](const dvec3& k) {
            const dvec3 s = p + frame * (k - 2.0 * glm::dot(plane, k) * plane) * radius;
            const double z = surface_z(picture, s, false);
            return z >= s.z + kBias && p.z - z < radius ? 1.0 : 0.0;
        });
    };
}

Estimator whinham_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius) {
    return [&picture, kernel, noise, radius](int x, int y) {
        const dvec3 p = picture.point(x, y), n = picture.smooth_normal(x, y);
        const glm::dmat3 frame = frame_of(across(tile_vector(noise, x, y), n), n);
        return open_part(kernel, [&](const dvec3& k) {
            const dvec3 s = p + frame * k * radius;
            return surface_z(picture, s, false) >= s.z ? 1.0 : 0.0;
        });
    };
}

ImageF box_blurred(const Picture& picture, const ImageF& visibility) {
    ImageF result = visibility;
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            if (!picture.surface(x, y)) continue;
            double sum = 0;
            for (int i = 0; i < 16; ++i) sum += clamped(visibility, x + i % 4 - 2, y + i / 4 - 2);
            result.at(x, y) = static_cast<float>(sum / 16);
        }
    }
    return result;
}

}  // namespace aoscore::testing::published
