#include "stress/stress_triangles.h"

#include <algorithm>

namespace aoscore {
namespace {

// Adds a vertex between two others; without normals the mesh stays flat.
unsigned add_between(Mesh& mesh, unsigned a, unsigned b, double part) {
    mesh.positions.push_back(
        glm::vec3(glm::mix(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]), part)));
    if (!mesh.normals.empty()) {
        mesh.normals.push_back(glm::vec3(
            glm::normalize(glm::mix(glm::dvec3(mesh.normals[a]), glm::dvec3(mesh.normals[b]), part))));
    }
    if (!mesh.texcoords.empty())
        mesh.texcoords.push_back(glm::mix(mesh.texcoords[a], mesh.texcoords[b], static_cast<float>(part)));
    if (!mesh.alphas.empty())
        mesh.alphas.push_back(glm::mix(mesh.alphas[a], mesh.alphas[b], static_cast<float>(part)));
    return static_cast<unsigned>(mesh.positions.size()) - 1;
}

double longest_edge(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
}

// Splits the triangles that have a longer edge than this.
void split_in_four(Mesh& mesh, double longer_than_m) {
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : std::vector<glm::uvec3>(mesh.triangles)) {
        if (longest_edge(mesh, t) <= longer_than_m) {
            triangles.push_back(t);
            continue;
        }
        const unsigned ab = add_between(mesh, t.x, t.y, 0.5), bc = add_between(mesh, t.y, t.z, 0.5),
                       ca = add_between(mesh, t.z, t.x, 0.5);
        for (const glm::uvec3& part : {glm::uvec3(t.x, ab, ca), glm::uvec3(ab, t.y, bc),
                                       glm::uvec3(ca, bc, t.z), glm::uvec3(ab, bc, ca)})
            triangles.push_back(part);
    }
    mesh.triangles = std::move(triangles);
}

}  // namespace

void split_to_edges(Scene& scene, double edge_m) {
    for (Mesh& mesh : scene.meshes) {
        for (std::size_t before = 0; before != mesh.triangles.size();) {
            before = mesh.triangles.size();
            split_in_four(mesh, edge_m);
        }
    }
}

void split_to_needles(Scene& scene, int most, std::size_t most_triangles) {
    for (Mesh& mesh : scene.meshes) {
        const auto room = static_cast<int>(most_triangles / std::max<std::size_t>(mesh.triangles.size(), 1));
        const int count = std::clamp(room, 1, most);
        std::vector<glm::uvec3> triangles;
        for (const glm::uvec3& t : std::vector<glm::uvec3>(mesh.triangles)) {
            unsigned before = t.y;
            for (int i = 1; i <= count; ++i) {
                const unsigned next = i == count ? t.z : add_between(mesh, t.y, t.z, double(i) / count);
                triangles.emplace_back(t.x, before, next);
                before = next;
            }
        }
        mesh.triangles = std::move(triangles);
    }
}

void add_triangles_without_area(Scene& scene) {
    for (Mesh& mesh : scene.meshes) {
        for (const glm::uvec3& t : std::vector<glm::uvec3>(mesh.triangles)) {
            for (const auto& [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)}) {
                mesh.triangles.emplace_back(a, b, b);
                mesh.triangles.emplace_back(a, add_between(mesh, a, b, 0.5), b);
            }
        }
    }
}

void add_surfaces_again(Scene& scene, double offset_m, bool split) {
    const std::size_t meshes = scene.meshes.size(), instances = scene.instances.size();
    for (std::size_t i = 0; i < meshes; ++i) {
        Mesh copy = scene.meshes[i];
        if (split) split_in_four(copy, 0);
        for (std::size_t v = 0; v < copy.normals.size(); ++v)
            copy.positions[v] =
                glm::vec3(glm::dvec3(copy.positions[v]) + offset_m * glm::dvec3(copy.normals[v]));
        scene.meshes.push_back(std::move(copy));
    }
    for (std::size_t i = 0; i < instances; ++i) {
        Instance again = scene.instances[i];
        again.mesh += static_cast<int>(meshes);
        scene.instances.push_back(again);
    }
}

}  // namespace aoscore
