#pragma once

#include "scene/builtin/mesh_builder.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace aoscore::builtin {

/// Puts a scene together from meshes and placements. Placements are built from exact numbers where parts
/// meet, so that neighbours share their seams to the last bit.
class SceneBuilder {
  public:
    /// Adds an opaque material and returns its index.
    int material(std::string name, const glm::vec3& albedo);
    /// Adds a cut-out material and returns its index.
    int cutout_material(std::string name, Texture texture, float alpha_cutoff);

    /// Adds a mesh and returns its index.
    int mesh(const MeshBuilder& shape, int material, double crease_rad = kCrease_rad);
    int place(int mesh, const glm::dmat4& scene_from_mesh = glm::dmat4(1.0));
    /// Places a mesh that moves in the scene.
    int place_dynamic(int mesh, const glm::dmat4& scene_from_mesh);

    Scene take() { return std::move(scene_); }

  private:
    Scene scene_;
};

glm::dmat4 translation(double x, double y, double z);
/// Exact rotation by `count` quarter turns about +y (z to x).
glm::dmat4 quarter_turns_y(int count);
glm::dmat4 rotation_x(double angle_rad);
glm::dmat4 rotation_y(double angle_rad);
glm::dmat4 rotation_z(double angle_rad);
glm::dmat4 scaling(double x, double y, double z);

/// A number in [0,1) that depends on `seed` and `index` alone: the generators' only randomness.
double hash_unit(std::uint32_t seed, std::uint32_t index);

}  // namespace aoscore::builtin
