#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Curtains in the lower arches and banners over the balustrade. Cloth is one sheet, visible from both sides.
namespace aoscore::builtin::atrium {
namespace {

using glm::dvec3;

constexpr double kRod_m = kLowerSpringing_m - 0.2;  ///< height of the curtain rods
constexpr double kHem_m = kStep_m + 0.12;
constexpr double kHalfWidth_m = 0.98;

/// Folds: a wave along the cloth, rounder than a sine, whose crests wander with the height.
double fold(double u, double v, double count, double phase) {
    const double wave = 2 * std::numbers::pi * (count * u + 0.12 * std::sin(5.1 * v + phase) + phase);
    return 0.75 * std::sin(wave) + 0.25 * std::sin(2 * wave + 1.3) + 0.35 * std::sin(0.37 * wave + 2.0 * v);
}

}  // namespace

MeshBuilder curtain_rod() {
    MeshBuilder lathed, mesh;
    add_lathe(lathed, {{0.022, -kBay_m / 2}, {0.022, kBay_m / 2}}, 8);
    mesh.append(lathed, translation(0, kRod_m, 0) * rotation_z(std::numbers::pi / 2));
    return mesh;
}

MeshBuilder drawn_curtain() {
    MeshBuilder mesh;
    add_surface(mesh, 48, 20, [](double u, double v) {
        const double down = 1 - v, depth = 0.035 + 0.055 * down;
        const double hem = 0.02 * std::sin(9 * u + 1) * down;
        const double x = (2 * u - 1) * kHalfWidth_m * (1 - 0.06 * std::sin(std::numbers::pi * down));
        return dvec3(x, kHem_m + (kRod_m - 0.03 - kHem_m) * v + hem, depth * fold(u, v, 7, 0.1));
    });
    return mesh;
}

/// A curtain gathered by a cord to the left side, a good third above the hem.
MeshBuilder tied_curtain() {
    MeshBuilder mesh;
    constexpr double kTie = 0.42;
    add_surface(mesh, 48, 24, [](double u, double v) {
        const double above = std::clamp((v - kTie) / (1 - kTie), 0.0, 1.0);
        const double below = std::clamp((kTie - v) / kTie, 0.0, 1.0);
        const double width = v >= kTie ? 0.26 + 1.7 * std::pow(above, 1.6) : 0.26 + 0.42 * std::sqrt(below);
        const double depth = 0.05 + 0.05 * below + 0.03 * (1 - above) - 0.02 * above;
        const double sag = 0.3 * u * std::sin(std::numbers::pi * above) * above;
        const double left = -kHalfWidth_m + 0.1 * std::sin(std::numbers::pi * above) * (1 - above);
        return dvec3(left + width * u,
                     kHem_m + (kRod_m - 0.03 - kHem_m) * v - sag + 0.015 * std::sin(11 * u) * below,
                     depth * fold(u, v, 8, 0.55));
    });
    MeshBuilder cord;
    add_torus(cord, 0.16, 0.022, 20, 6);
    mesh.append(cord, translation(-kHalfWidth_m + 0.13, kHem_m + (kRod_m - kHem_m) * kTie, 0) *
                          scaling(1.05, 1, 0.72) * rotation_x(std::numbers::pi / 2));
    return mesh;
}

/// A cloth laid over the balustrade that falls in front of the cornice; the court is on -z.
MeshBuilder banner() {
    // Its line from the gallery side over the rail and down, in (z, y), with the arc length at each corner.
    const double rail = kUpperFloor_m + kParapet_m;
    const Profile line{
        {0.23, rail - 0.55},           {0.215, rail + 0.015},        {0, rail + 0.03}, {-0.215, rail + 0.015},
        {-0.56, kUpperFloor_m + 0.06}, {-0.56, kUpperFloor_m - 0.8}, {-0.55, 3.9}};
    std::vector<double> reached{0};
    for (std::size_t i = 1; i < line.size(); ++i)
        reached.push_back(reached.back() + glm::length(line[i] - line[i - 1]));
    constexpr int kRows = 36;
    MeshBuilder mesh;
    add_surface(mesh, 20, kRows, [&](double u, double v) {
        const double s = (1 - v) * reached.back();
        std::size_t i = 1;
        while (i + 1 < line.size() && reached[i] < s) ++i;
        const glm::dvec2 p =
            glm::mix(line[i - 1], line[i], (s - reached[i - 1]) / (reached[i] - reached[i - 1]));
        const double free = std::clamp((s - 1.9) / 1.5, 0.0, 1.0);  // below the cornice it hangs freely
        const double ripple = 0.07 * free * fold(u, v, 3, 0.3) - 0.03 * free;
        return dvec3((1 - 2 * u) * 0.62, p.y, p.x - std::abs(ripple));
    });
    return mesh;
}

}  // namespace aoscore::builtin::atrium
