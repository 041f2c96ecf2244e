#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// The carved lion's head of the atrium: a height field of rounded bosses and dents, framed by a mane of
/// locks. Lengths are metres; the head faces +z, its background is z = 0.
namespace aoscore::builtin::atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kHalfSize_m = 0.7;
constexpr int kCells = 176;
constexpr double kGround_m = -0.03;  ///< buried in the panel

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// The larger of both, rounded over a transition of about `width`.
double smooth_max(double a, double b, double width) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::max(a, b) + h * h * width * 0.25;
}

/// Half an ellipsoid that stands on the background; falls away steeply outside its outline.
double boss(const dvec2& p, const dvec2& centre, const dvec2& radii, double foot, double top) {
    const double q = glm::length((p - centre) / radii);
    if (q >= 1) return foot - (q - 1) * 0.5;
    return foot + (top - foot) * std::sqrt(1 - q * q);
}

/// A rounded ridge from a to b, with radius and top height at both ends.
double ridge(const dvec2& p, const dvec2& a, const dvec2& b, const dvec2& radii, const dvec2& tops) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const double radius = glm::mix(radii.x, radii.y, t), top = glm::mix(tops.x, tops.y, t);
    const double q = glm::length(p - glm::mix(a, b, t)) / radius;
    return q >= 1 ? top - radius - (q - 1) * 0.5 : top - radius + radius * std::sqrt(1 - q * q);
}

double dent(const dvec2& p, const dvec2& centre, const dvec2& radii) {
    const dvec2 q = (p - centre) / radii;
    return std::exp(-glm::dot(q, q));
}

/// One ring of pointed, combed locks that start at radius `from` and lie `length` outwards.
struct Locks {
    int count;
    double shift, from, length, height;
};

double locks(const dvec2& p, const Locks& ring) {
    const double r = glm::length(p);
    const double turn =
        std::atan2(p.x, -p.y) / (2 * std::numbers::pi);  // 0 at the chin, the locks part above
    const double t = (r - ring.from) / ring.length;
    if (t < -0.4 || t > 1) return kGround_m;
    // Each lock bends to the chin and then back, like an S.
    const double sweep = (turn > 0 ? 1 : -1) * std::min(8 * std::abs(turn), 8 * (0.5 - std::abs(turn)));
    const double lane =
        turn * ring.count + ring.shift + 0.55 * std::clamp(sweep, -1.0, 1.0) * std::sin(2.6 * t);
    const double across = lane - std::floor(lane) - 0.5;
    const auto number = static_cast<std::uint32_t>(static_cast<int>(std::floor(lane)) + 64 * ring.count);
    const double vary = hash_unit(7, number);
    const double u = std::clamp(t / (0.75 + 0.25 * vary), 0.0, 1.0);
    const double half = 0.56 * std::pow(1 - u, 0.55);
    if (std::abs(across) >= half) return kGround_m;
    const double q = across / half;
    const double comb = 0.007 * std::cos((q + 0.3 * vary) * 2.5 * std::numbers::pi) * (1 - u);
    return (ring.height * (1 - 0.5 * u) + 0.02 * vary + comb) * std::pow(1 - q * q, 0.55);
}

double face(dvec2 p) {
    const double side = p.x;
    p.x = std::abs(p.x);
    double z = boss(p, {0, -0.01}, {0.35, 0.42}, 0.0, 0.225);
    const auto add = [&](double h, double width) { z = smooth_max(z, h, width); };
    add(boss(p, {0.07, 0.245}, {0.13, 0.11}, 0.12, 0.285), 0.06);
    add(boss(p, {0.225, -0.06}, {0.115, 0.17}, 0.08, 0.25), 0.06);
    z -= 0.07 * dent(p, {0.125, 0.075}, {0.07, 0.045});
    add(ridge(p, {0.065, 0.115}, {0.2, 0.175}, {0.042, 0.03}, {0.272, 0.245}), 0.05);
    add(ridge(p, {0, 0.21}, {0, -0.06}, {0.05, 0.085}, {0.27, 0.37}), 0.06);
    add(boss(p, {0.1, -0.15}, {0.125, 0.095}, 0.17, 0.37), 0.035);
    add(boss(p, {0, -0.078}, {0.105, 0.048}, 0.25, 0.41), 0.02);
    add(boss(p, {0, -0.305}, {0.1, 0.065}, 0.1, 0.315), 0.03);
    // Eyes: lid, ball, pupil, the fold below.
    add(boss(p, {0.125, 0.075}, {0.055, 0.034}, 0.13, 0.236), 0.008);
    z -= 0.022 * dent(p, {0.12, 0.075}, {0.014, 0.014});
    z -= 0.016 * dent(p, {0.125, 0.034}, {0.065, 0.008});
    // Nostrils, the groove under the nose, the open mouth, furrows and whisker holes.
    z -= 0.05 * dent(p, {0.05, -0.092}, {0.02, 0.013});
    z -= 0.06 * dent(p, {0, -0.165}, {0.01, 0.06});
    z -= 0.2 * dent(p, {0, -0.248}, {0.125, 0.021});
    z -= 0.035 * dent(p, {0, 0.26}, {0.014, 0.08});
    z -= 0.018 * dent(p, {0.07, 0.215}, {0.1, 0.011});
    z -= 0.025 * dent(p, {0.215, -0.16}, {0.02, 0.09});
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k) {
            z -= 0.016 * dent(p, {0.08 + 0.036 * k, -0.125 - 0.026 * row - 0.007 * k}, {0.008, 0.008});
        }
    }
    // A carver's hand is not a mirror.
    return z + 0.004 * std::sin(17 * side + 9 * p.y);
}

double height_at(const dvec2& p) {
    constexpr Locks kMane[] = {{30, 0.0, 0.46, 0.24, 0.09},
                               {27, 0.5, 0.40, 0.22, 0.125},
                               {24, 0.25, 0.34, 0.20, 0.155},
                               {21, 0.75, 0.28, 0.18, 0.19}};
    double z = kGround_m;
    for (const Locks& ring : kMane) z = std::max(z, locks(p, ring));
    // The mane's own body closes the gaps between the roots of the locks.
    z = std::max(z, glm::mix(kGround_m, 0.06, smoothstep(0.58, 0.5, glm::length(p))));
    const dvec2 mirrored(std::abs(p.x), p.y);
    double ear = boss(mirrored, {0.28, 0.315}, {0.09, 0.095}, 0.06, 0.26);
    ear -= 0.11 * dent(mirrored, {0.275, 0.305}, {0.042, 0.047});
    z = std::max(z, ear);
    const double edge = 0.325 + 0.02 * std::sin(13 * std::atan2(p.x, p.y));
    const double mask = smoothstep(edge + 0.06, edge - 0.02, glm::length(p * dvec2(1.0, 0.9)));
    if (mask > 0) z = smooth_max(z, glm::mix(kGround_m, face(p), mask), 0.012);
    return std::max(z, kGround_m);
}

}  // namespace

MeshBuilder lion_head() {
    MeshBuilder mesh;
    const double cell = 2 * kHalfSize_m / kCells;
    const auto point = [&](int i, int k) {
        const dvec2 p(i * cell - kHalfSize_m, k * cell - kHalfSize_m);
        return dvec3(p, height_at(p));
    };
    std::vector<dvec3> row, next;
    for (int i = 0; i <= kCells; ++i) next.push_back(point(i, 0));
    for (int k = 0; k < kCells; ++k) {
        row = next;
        for (int i = 0; i <= kCells; ++i) next[static_cast<std::size_t>(i)] = point(i, k + 1);
        for (std::size_t i = 0; i < static_cast<std::size_t>(kCells); ++i) {
            const dvec3 a = row[i], b = row[i + 1], c = next[i + 1], d = next[i];
            if (std::max({a.z, b.z, c.z, d.z}) <= kGround_m)
                continue;  // nothing stands out of the panel here
            if (std::abs(a.z - c.z) <= std::abs(b.z - d.z)) {
                mesh.quad(a, b, c, d);
            } else {
                mesh.quad(b, c, d, a);
            }
        }
    }
    // The ring in the mouth.
    MeshBuilder ring;
    add_torus(ring, 0.125, 0.017, 40, 10);
    mesh.append(ring, translation(0, -0.365, 0.325) * rotation_x(0.1));
    return mesh;
}

/// The panel's moulded roundel about the head.
MeshBuilder medallion_frame() {
    Profile section{{0.95, -0.05}, {0.95, 0.03}};
    append_arc(section, {0.9, 0.03}, {0.05, 0.05}, 0, std::numbers::pi, 6);
    section.emplace_back(0.83, 0.035);
    append_arc(section, {0.78, 0.035}, {0.05, 0.035}, std::numbers::pi / 6, std::numbers::pi, 5);
    section.emplace_back(0.72, -0.05);
    MeshBuilder lathed, mesh;
    add_lathe(lathed, section, 72);
    // Beads in the hollow between both mouldings.
    mesh.append(lathed, rotation_x(std::numbers::pi / 2));
    MeshBuilder bead;
    add_sphere(bead, {0, 0, 0}, 0.021, 1);
    constexpr int kBeads = 60;
    for (int i = 0; i < kBeads; ++i) {
        mesh.append(bead, rotation_z(2 * std::numbers::pi * i / kBeads) * translation(0.839, 0, 0.045));
    }
    return mesh;
}

}  // namespace aoscore::builtin::atrium
