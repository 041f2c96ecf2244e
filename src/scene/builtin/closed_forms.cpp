#include "scene/builtin/closed_forms.h"

#include <algorithm>
#include <cmath>

namespace aoscore::closed_form {
namespace {

constexpr double kOnSurface_m = 1e-3;
constexpr double kFarthest_m = 10;

std::optional<double> at_wall(const glm::dvec3& p, double height_m, double radius_m) {
    const double distance = p.x;
    if (distance < 0.01) return std::nullopt;
    if (std::isinf(radius_m)) return wall_visibility(distance, height_m);
    // The rays' reach is a circle on the wall's plane: it must not extend over the top or past the ends.
    if (std::sqrt(std::max(radius_m * radius_m - distance * distance, 0.0)) > height_m) return std::nullopt;
    return wall_visibility_cutoff(distance, radius_m);
}

std::optional<double> at_pit_bottom(const glm::dvec3& p, double radius_m) {
    const double offset = std::hypot(p.x, p.z);
    if (offset > pit::kRadius_m - 0.01) return std::nullopt;
    const double farthest_rim = std::hypot(pit::kRadius_m + offset, pit::depth_m());
    if (radius_m >= farthest_rim) return pit_visibility_at(offset, pit::kRadius_m, pit::depth_m());
    if (radius_m <= pit::kRadius_m - offset) return 1.0;
    return std::nullopt;
}

}  // namespace

glm::dvec3 plane::normal() {
    return glm::normalize(glm::dvec3(0.3, 0.9, 0.2));
}

double pit::depth_m() {
    return kRadius_m / std::tan(kRimZenith_rad);
}

double wall_visibility(double distance_m, double height_m) {
    return 0.5 * (1 + distance_m / std::hypot(distance_m, height_m));
}

double wall_visibility_cutoff(double distance_m, double radius_m) {
    const double c = std::min(distance_m / radius_m, 1.0);
    return 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi;
}

double sphere_visibility(double distance_m, double angle_rad, double sphere_radius_m, double radius_m) {
    const double d = distance_m, r = sphere_radius_m, reach = radius_m;
    double sine_squared = (r / d) * (r / d);
    if (reach * reach < d * d - r * r) {
        if (reach <= d - r) return 1;
        const double cosine = (reach * reach + d * d - r * r) / (2 * reach * d);
        sine_squared = 1 - cosine * cosine;
    }
    return 1 - sine_squared * std::cos(angle_rad);
}

double pit_visibility(double rim_zenith_rad) {
    const double sine = std::sin(rim_zenith_rad);
    return sine * sine;
}

double pit_visibility_at(double offset_m, double pit_radius_m, double pit_depth_m) {
    const double a2 = offset_m * offset_m, r2 = pit_radius_m * pit_radius_m, h2 = pit_depth_m * pit_depth_m;
    const double z = a2 + h2 + r2;
    return 0.5 * (1 - (a2 + h2 - r2) / std::sqrt(z * z - 4 * r2 * a2));
}

std::optional<double> expected_visibility(std::string_view scene_id, const glm::dvec3& p, double radius_m) {
    if (glm::length(p) > kFarthest_m) return std::nullopt;
    if (scene_id == "plane") {
        if (std::abs(glm::dot(p, plane::normal())) > kOnSurface_m) return std::nullopt;
        return 1.0;
    }
    if (std::abs(p.y) > kOnSurface_m) return std::nullopt;
    if (scene_id == "wall") return at_wall(p, wall::kHeight_m, radius_m);
    if (scene_id == "wall_tall") return at_wall(p, wall::kTallHeight_m, radius_m);
    if (scene_id == "sphere") {
        const double distance = glm::length(p - glm::dvec3(0, sphere::kCentreHeight_m, 0));
        return sphere_visibility(distance, std::acos(sphere::kCentreHeight_m / distance), sphere::kRadius_m,
                                 radius_m);
    }
    if (scene_id == "pit") return at_pit_bottom(p, radius_m);
    return std::nullopt;
}

}  // namespace aoscore::closed_form
