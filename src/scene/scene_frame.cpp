#include "scene/scene_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

struct Unit {
    std::string_view name;
    double metres;
};
constexpr std::array<Unit, 6> kUnits{
    {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}, {"km", 1000}}};

Bounds changed(const Bounds& bounds, const SceneFrame& frame) {
    const glm::dvec3 a = frame.metres_per_unit * (frame.y_up_from_file * bounds.low);
    const glm::dvec3 b = frame.metres_per_unit * (frame.y_up_from_file * bounds.high);
    return {glm::min(a, b), glm::max(a, b)};
}

/// The factor that scales one box closest to another, by least squares over their corners.
double closest_factor(const Bounds& from, const Bounds& to) {
    const double product = glm::dot(from.low, to.low) + glm::dot(from.high, to.high);
    return product / (glm::dot(from.low, from.low) + glm::dot(from.high, from.high));
}

/// Factors to be tried, the likeliest first: those of units near the closest one, then the closest factor
/// itself where the file's bounds are exact enough for that.
std::vector<double> likely_factors(double closest, const ViewFile& views) {
    constexpr double kNear = 0.3, kExact = 0.01;  // share of the factor; share of the diagonal
    std::vector<double> factors;
    for (const Unit& unit : kUnits) {
        for (const double factor : {unit.metres, 1 / unit.metres}) {
            if (std::abs(std::log(factor / closest)) < kNear) factors.push_back(factor);
        }
    }
    if (views.tolerance_m <= kExact * views.bounds.diagonal()) factors.push_back(closest);
    return factors;
}

std::optional<double> fitting_factor(const ViewFile& views, const Bounds& bounds) {
    const double closest = closest_factor(bounds, views.bounds);
    if (!(closest > 0) || !std::isfinite(closest)) return std::nullopt;
    for (const double factor : likely_factors(closest, views)) {
        if (bounds_match(views, changed(bounds, {factor, glm::dmat3(1)}))) return factor;
    }
    return std::nullopt;
}

}  // namespace

glm::dmat3 y_up_from(UpAxis up) {
    if (up == UpAxis::y) return glm::dmat3(1);
    return {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0)};
}

void apply_frame(Scene& scene, const SceneFrame& frame) {
    const glm::dmat3 linear = frame.metres_per_unit * frame.y_up_from_file;
    if (linear == glm::dmat3(1)) return;
    for (Instance& instance : scene.instances)
        instance.scene_from_mesh = glm::dmat4(linear) * instance.scene_from_mesh;
    for (View& view : scene.views) {
        Camera& camera = view.camera;
        camera.position = linear * camera.position;
        camera.target = linear * camera.target;
        camera.up = frame.y_up_from_file * camera.up;
        for (double* length : {&camera.near, &camera.far, &camera.half_height})
            *length *= frame.metres_per_unit;
    }
}

std::optional<double> parse_unit(std::string_view text) {
    for (const Unit& unit : kUnits) {
        if (unit.name == text) return unit.metres;
    }
    double metres = 0;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), metres);
    if (ec != std::errc() || end != text.data() + text.size()) return std::nullopt;
    // These keep the diagonal of any scene a float32.
    constexpr double kSmallest = 1e-12, kLargest = 1e12;
    return metres >= kSmallest && metres <= kLargest ? std::optional(metres) : std::nullopt;
}

std::string unit_text(double metres_per_unit) {
    for (const Unit& unit : kUnits) {
        if (unit.metres == metres_per_unit) return std::string(unit.name);
    }
    return fmt::format("{}", metres_per_unit);
}

std::string frame_options(const LoadOptions& options) {
    std::string words;
    if (options.metres_per_unit) words += " --unit " + unit_text(*options.metres_per_unit);
    if (options.up) words += *options.up == UpAxis::y ? " --up y" : " --up z";
    return words;
}

std::optional<SceneFrame> recognise(const ViewFile& views, const Bounds& bounds, bool may_scale,
                                    bool may_turn) {
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        if (up == UpAxis::z && !may_turn) continue;
        SceneFrame frame{1, y_up_from(up)};
        const Bounds turned = changed(bounds, frame);
        if (bounds_match(views, turned)) return frame;
        if (!may_scale) continue;
        if (const std::optional<double> factor = fitting_factor(views, turned)) {
            frame.metres_per_unit = *factor;
            return frame;
        }
    }
    return std::nullopt;
}

}  // namespace aoscore
