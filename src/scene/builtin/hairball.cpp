#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"

#include <array>
#include <cmath>
#include <numbers>

namespace aoscore::builtin {
namespace {

using glm::dvec3;

/// A tuft is a mesh; the ball is the same tuft turned many ways.
constexpr int kTufts = 28, kStrands = 128, kSegments = 48, kSides = 3;
constexpr double kTube_m = 0.0018;
constexpr double kCircle_rad = 2 * std::numbers::pi;

dvec3 direction(std::uint32_t seed, std::uint32_t index) {
    const double z = 2 * hash_unit(seed, 2 * index) - 1, angle = kCircle_rad * hash_unit(seed, 2 * index + 1);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A point of a strand's centre line, which runs from the core to the surface and curls about the line
/// outwards.
dvec3 strand_point(std::uint32_t strand, double t) {
    const dvec3 out = direction(11, strand);
    const dvec3 side = glm::normalize(glm::cross(out, direction(12, strand)));
    const dvec3 other = glm::cross(out, side);
    const double angle = kCircle_rad * (hash_unit(13, strand) + (0.8 + 1.4 * hash_unit(14, strand)) * t);
    const double curl = 0.32 * t * (1 - 0.4 * t);
    const double reach = 0.18 + 0.72 * (0.75 + 0.25 * hash_unit(15, strand)) * t;
    return reach * out + curl * (std::cos(angle) * side + std::sin(angle) * other);
}

using Ring = std::array<dvec3, kSides>;

Ring ring_about(const dvec3& centre, const dvec3& along, dvec3& side) {
    side = glm::normalize(side - glm::dot(side, along) * along);
    const dvec3 other = glm::cross(along, side);
    Ring ring;
    for (int k = 0; k < kSides; ++k) {
        const double angle = kCircle_rad * k / kSides;
        ring[static_cast<std::size_t>(k)] =
            centre + kTube_m * (std::cos(angle) * side + std::sin(angle) * other);
    }
    return ring;
}

void add_strand(MeshBuilder& mesh, std::uint32_t strand) {
    dvec3 side = direction(16, strand);
    Ring before;
    for (int i = 0; i <= kSegments; ++i) {
        const double t = static_cast<double>(i) / kSegments, step = 0.5 / kSegments;
        const dvec3 along = glm::normalize(strand_point(strand, t + step) - strand_point(strand, t - step));
        const Ring ring = ring_about(strand_point(strand, t), along, side);
        for (std::size_t k = 0; i > 0 && k < kSides; ++k) {
            const std::size_t next = (k + 1) % kSides;
            mesh.quad(before[k], before[next], ring[next], ring[k]);
        }
        before = ring;
    }
}

glm::dmat4 turned(std::uint32_t tuft) {
    return rotation_z(kCircle_rad * hash_unit(21, tuft)) * rotation_y(kCircle_rad * hash_unit(22, tuft)) *
           rotation_x(kCircle_rad * hash_unit(23, tuft));
}

}  // namespace

/// More than a million triangles thinner than a pixel, many layers deep everywhere: the worst case for depth
/// buffers of several layers, which stands in for the hairball of Vermeer, Stochastic-Depth Ambient
/// Occlusion, 2020, table 9.1.
Scene generate_hairball() {
    SceneBuilder scene;
    const int hair = scene.material("hair", glm::vec3(0.5f, 0.42f, 0.35f));
    MeshBuilder tuft;
    for (std::uint32_t strand = 0; strand < kStrands; ++strand) add_strand(tuft, strand);
    constexpr double kAllSmooth_rad = 1.0;  // across a tube edges stay sharp, along it they do not
    const int tufts = scene.mesh(tuft, hair, kAllSmooth_rad);
    for (std::uint32_t i = 0; i < kTufts; ++i) scene.place(tufts, turned(i));
    return scene.take();
}

}  // namespace aoscore::builtin
