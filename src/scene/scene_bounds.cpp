#include "scene/scene_bounds.h"

#include "core/error.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace aoscore {
namespace {

constexpr double kMaxDiagonal = 1e9;
constexpr double kTinyDiagonal = 1e-6;
constexpr std::size_t kMaxTriangles = 64'000'000;

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void measure_scene(Scene& scene, const std::string& where) {
    scene.triangle_count = 0;
    for (const Instance& instance : scene.instances) {
        scene.triangle_count += scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
    }
    if (scene.triangle_count > kMaxTriangles) {
        throw file_error(fmt::format("its instances have {} triangles", scene.triangle_count), where,
                         fmt::format("at most {}", kMaxTriangles));
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kInfinity), high(-kInfinity);
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const glm::dmat3 linear(instance.scene_from_mesh);
        const glm::dvec3 place(instance.scene_from_mesh[3]);
        for (const glm::uvec3& triangle : mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) {
                const glm::dvec3 p = linear * glm::dvec3(mesh.positions[triangle[corner]]) + place;
                if (!is_finite(p)) throw file_error("its transforms put vertices at infinity", where);
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        }
    }
    scene.bounds = {low, high};
    const double diagonal = scene.bounds.diagonal();
    if (!(diagonal <= kMaxDiagonal)) {
        throw file_error(fmt::format("is {:.3g} m wide", diagonal), where,
                         fmt::format("at most {:.0e} m", kMaxDiagonal));
    }
    if (diagonal < kTinyDiagonal) {
        scene.warnings.push_back(
            fmt::format("the whole scene is {:.3g} m wide: float32 may lose areas", diagonal));
    }
}

glm::dvec3 suitable_origin(const Bounds& bounds) {
    const double distance = glm::length(bounds.centre()), diagonal = bounds.diagonal();
    const bool is_far = distance > 1000 * diagonal || (distance > 1e4 && distance > diagonal);
    if (!is_far || !(diagonal > 0)) return glm::dvec3(0.0);
    const double unit = std::exp2(std::floor(std::log2(diagonal)));
    return glm::round(bounds.centre() / unit) * unit;
}

void move_origin(Scene& scene, const glm::dvec3& origin) {
    for (Instance& instance : scene.instances) instance.scene_from_mesh[3] -= glm::dvec4(origin, 0);
    for (View& view : scene.views) {
        view.camera.position -= origin;
        view.camera.target -= origin;
    }
    scene.bounds.low -= origin;
    scene.bounds.high -= origin;
    scene.origin += origin;
}

}  // namespace aoscore
