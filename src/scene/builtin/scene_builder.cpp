#include "scene/builtin/scene_builder.h"

#include <cmath>
#include <utility>

namespace aoscore::builtin {

int SceneBuilder::material(std::string name, const glm::vec3& albedo) {
    Material material;
    material.name = std::move(name);
    material.base_color = glm::vec4(albedo, 1);
    scene_.materials.push_back(std::move(material));
    return static_cast<int>(scene_.materials.size()) - 1;
}

int SceneBuilder::cutout_material(std::string name, Texture texture, float alpha_cutoff) {
    const int index = material(std::move(name), glm::vec3(1));
    scene_.textures.push_back(std::move(texture));
    scene_.materials.back().texture = static_cast<int>(scene_.textures.size()) - 1;
    scene_.materials.back().alpha_cutoff = alpha_cutoff;
    return index;
}

int SceneBuilder::mesh(const MeshBuilder& shape, int material, double crease_rad) {
    const bool textured = scene_.materials[static_cast<std::size_t>(material)].texture >= 0;
    scene_.meshes.push_back(shape.finish(material, crease_rad, textured));
    return static_cast<int>(scene_.meshes.size()) - 1;
}

int SceneBuilder::place(int mesh, const glm::dmat4& scene_from_mesh) {
    scene_.instances.push_back({mesh, scene_from_mesh});
    return mesh;
}

int SceneBuilder::place_dynamic(int mesh, const glm::dmat4& scene_from_mesh) {
    place(mesh, scene_from_mesh);
    scene_.instances.back().is_dynamic = true;
    return mesh;
}

glm::dmat4 translation(double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(x, y, z, 1);
    return m;
}

namespace {

glm::dmat4 turn_y(double sine, double cosine) {
    glm::dmat4 m(1.0);
    m[0] = glm::dvec4(cosine, 0, -sine, 0);
    m[2] = glm::dvec4(sine, 0, cosine, 0);
    return m;
}

}  // namespace

glm::dmat4 quarter_turns_y(int count) {
    constexpr double kSine[4] = {0, 1, 0, -1};
    return turn_y(kSine[count & 3], kSine[(count + 1) & 3]);
}

glm::dmat4 rotation_x(double angle_rad) {
    glm::dmat4 m(1.0);
    m[1] = glm::dvec4(0, std::cos(angle_rad), std::sin(angle_rad), 0);
    m[2] = glm::dvec4(0, -std::sin(angle_rad), std::cos(angle_rad), 0);
    return m;
}

glm::dmat4 rotation_y(double angle_rad) {
    return turn_y(std::sin(angle_rad), std::cos(angle_rad));
}

glm::dmat4 rotation_z(double angle_rad) {
    glm::dmat4 m(1.0);
    m[0] = glm::dvec4(std::cos(angle_rad), std::sin(angle_rad), 0, 0);
    m[1] = glm::dvec4(-std::sin(angle_rad), std::cos(angle_rad), 0, 0);
    return m;
}

glm::dmat4 scaling(double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

double hash_unit(std::uint32_t seed, std::uint32_t index) {
    // A 32-bit finaliser (multiply, shift) over seed and index.
    std::uint32_t h = seed * 0x9e3779b1u + index * 0x85ebca77u + 0x165667b1u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    return static_cast<double>(h) / 4294967296.0;
}

}  // namespace aoscore::builtin
