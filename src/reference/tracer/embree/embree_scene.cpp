#include "reference/tracer/embree/embree_scene.h"

#include "reference/tracer/embree/cutout_filter.h"
#include "scene/cofactors.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace aoscore {
namespace {

/// How much farther than asked for triangles are searched, of the scene's diagonal: boxes in trees are
/// float32, and where triangles are split between them rounded.
constexpr double kSearchMarginPart = 1e-6;

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& p) {
    return glm::dvec3(m * glm::dvec4(p, 1));
}

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    void include(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    double diagonal() const { return low.x <= high.x ? glm::distance(low, high) : 0; }
    glm::dvec3 centre() const { return low.x <= high.x ? (low + high) / 2.0 : glm::dvec3(0); }
};

Box box_of(const Scene& scene) {
    Box box;
    for (const Instance& instance : scene.instances) {
        for (const glm::vec3& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            box.include(transformed(instance.scene_from_mesh, p));
        }
    }
    return box;
}

glm::dvec3 centre_of(const Mesh& mesh) {
    Box box;
    for (const glm::vec3& p : mesh.positions) box.include(p);
    return box.centre();
}

bool mirrors(const glm::dmat4& m) {
    return glm::determinant(glm::dmat3(m)) < 0;
}

/// The matrix that Embree gets: rounded to float32, then read back.
glm::dmat4 rounded(const glm::dmat4& m) {
    return glm::dmat4(glm::mat4(m));
}

}  // namespace

bool EmbreeScene::count_memory(void* memory, ssize_t bytes, bool) {
    Memory& m = *static_cast<Memory*>(memory);
    const std::ptrdiff_t now = m.current += bytes;
    std::size_t peak = m.peak;
    while (now > 0 && static_cast<std::size_t>(now) > peak &&
           !m.peak.compare_exchange_weak(peak, static_cast<std::size_t>(now))) {
    }
    return true;
}

EmbreeScene::EmbreeScene(const Scene& scene, const TraceBuild& build, const std::vector<char>& wanted,
                         double rays)
    : device_(rtcNewDevice(nullptr)) {
    check_embree(device_.get(), "starting Embree");
    rtcSetDeviceMemoryMonitorFunction(device_.get(), count_memory, &memory_);
    copy_cutouts(scene);
    const Box box = box_of(scene);
    centre_ = box.centre();
    diagonal_m_ = box.diagonal();

    std::vector<int> uses(scene.meshes.size());
    for (const Instance& instance : scene.instances) {
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        ++uses[mesh];
        triangle_count_ += scene.meshes[mesh].triangles.size();
    }
    const bool bake_all = triangle_count_ <= build.baked_triangles_at_most;

    std::uint64_t in_trees = 0;
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh)
        in_trees += static_cast<std::uint64_t>(bake_all ? uses[mesh] : std::min(uses[mesh], 1)) *
                    scene.meshes[mesh].triangles.size();
    effort_ = tree_effort(in_trees, rays);
    scene_ = new_trace_scene(device_.get(), effort_);
    const glm::dmat4 to_trace_space = glm::translate(glm::dmat4(1), -centre_);

    struct Shared {
        const TraceGeometry* geometry = nullptr;
        RTCScene scene = nullptr;
        glm::dvec3 centre{0};
    };
    std::vector<Shared> shared(scene.meshes.size());
    for (std::size_t number = 0; number < scene.instances.size(); ++number) {
        const Instance& instance = scene.instances[number];
        const auto index = static_cast<std::size_t>(instance.mesh);
        const Mesh& mesh = scene.meshes[index];
        if (mesh.triangles.empty()) continue;
        const bool baked = bake_all || uses[index] == 1;
        has_instances_ = has_instances_ || !baked;
        if (!wanted.empty() && wanted[number] == 0) continue;
        const glm::dmat4 transform = to_trace_space * instance.scene_from_mesh;
        if (baked) {
            const TraceGeometry& geometry = add_triangles(scene_.get(), mesh, transform);
            placements_.push_back({&geometry, glm::dmat4(1), false, number, mirrors(transform)});
            continue;
        }
        Shared& s = shared[index];
        if (s.scene == nullptr) {
            s.centre = centre_of(mesh);
            shared_.push_back(new_trace_scene(device_.get(), effort_));
            s.scene = shared_.back().get();
            s.geometry = &add_triangles(s.scene, mesh, glm::translate(glm::dmat4(1), -s.centre));
            rtcCommitScene(s.scene);
            check_embree(device_.get(), "building a shared mesh");
        }
        add_instance(*s.geometry, s.scene, transform * glm::translate(glm::dmat4(1), s.centre), number);
    }
    rtcCommitScene(scene_.get());
    check_embree(device_.get(), "building the scene");
}

void EmbreeScene::copy_cutouts(const Scene& scene) {
    cutouts_.materials = scene.materials;
    cutouts_.textures.resize(scene.textures.size());
    for (const Material& material : scene.materials) {
        if (!material.is_cutout() || material.texture < 0) continue;
        const auto texture = static_cast<std::size_t>(material.texture);
        cutouts_.textures[texture] = scene.textures[texture];
    }
}

TraceGeometry& EmbreeScene::add_triangles(RTCScene target, const Mesh& mesh, const glm::dmat4& transform) {
    GeometryHandle handle(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    rtcSetGeometryBuildQuality(handle.get(), build_quality(effort_));
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(handle.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                     RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                                                     mesh.positions.size()));
    auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
        handle.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh.triangles.size()));
    check_embree(device_.get(), "storing a mesh");
    std::transform(mesh.positions.begin(), mesh.positions.end(), vertices,
                   [&](const glm::vec3& p) { return glm::vec3(transformed(transform, p)); });
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);

    TraceGeometry& geometry = geometries_.emplace_back();
    geometry.vertices = vertices;
    geometry.triangles = triangles;
    geometry.triangle_count = static_cast<unsigned>(mesh.triangles.size());
    if (!mesh.normals.empty()) {
        const glm::dmat3 turn = cofactors(glm::dmat3(transform));
        geometry.normals.reserve(mesh.normals.size());
        for (const glm::vec3& n : mesh.normals) {
            const glm::dvec3 turned = turn * glm::dvec3(n);
            const double length = glm::length(turned);
            geometry.normals.push_back(length > 0 ? glm::vec3(turned / length) : glm::vec3(0));
        }
    }
    const Material& material = cutouts_.materials[static_cast<std::size_t>(mesh.material)];
    if (material.is_cutout()) {
        geometry.texcoords = mesh.texcoords;
        geometry.alphas = mesh.alphas;
        geometry.material = &material;
        geometry.cutouts = &cutouts_;
        rtcSetGeometryUserData(handle.get(), &geometry);
        set_cutout_filter(handle.get());
    }
    rtcCommitGeometry(handle.get());
    rtcAttachGeometry(target, handle.get());
    check_embree(device_.get(), "adding a mesh");
    return geometry;
}

void EmbreeScene::add_instance(const TraceGeometry& geometry, RTCScene shared, const glm::dmat4& transform,
                               std::size_t number) {
    GeometryHandle handle(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(handle.get(), shared);
    const glm::mat4 matrix(transform);
    rtcSetGeometryTransform(handle.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrix);
    rtcCommitGeometry(handle.get());
    rtcAttachGeometry(scene_.get(), handle.get());
    check_embree(device_.get(), "adding an instance");
    placements_.push_back({&geometry, rounded(transform), true, number, mirrors(transform)});
}

TraceTriangle EmbreeScene::triangle(const Placement& placement, unsigned index) const {
    const TraceGeometry& geometry = *placement.geometry;
    const glm::uvec3 corner = geometry.triangles[index];
    const auto vertex = [&](unsigned i) {
        return transformed(placement.trace_from_geometry, glm::dvec3(geometry.vertices[i]));
    };
    return {{vertex(corner.x), vertex(corner.y), vertex(corner.z)}};
}

std::vector<TraceTriangle> EmbreeScene::largest_triangles(std::size_t count) const {
    struct Candidate {
        double area;
        TraceTriangle triangle;
    };
    const auto is_larger = [](const Candidate& a, const Candidate& b) { return a.area > b.area; };
    std::vector<Candidate> heap;  // the smallest in front; a scene's triangles are too many to be copied
    for (const Placement& placement : placements_) {
        if (placement.is_instance || placement.geometry->material != nullptr) continue;
        for (unsigned i = 0; i < placement.geometry->triangle_count; ++i) {
            const TraceTriangle one = triangle(placement, i);
            const double area = one.area();
            if (heap.size() == count) {
                if (area <= heap.front().area) continue;
                std::ranges::pop_heap(heap, is_larger);
                heap.pop_back();
            }
            heap.push_back({area, one});
            std::ranges::push_heap(heap, is_larger);
        }
    }
    std::vector<TraceTriangle> largest;
    for (const Candidate& candidate : heap) largest.push_back(candidate.triangle);
    return largest;
}

const Occluders* EmbreeScene::large_triangles() const {
    std::call_once(walls_asked_for_, [&] {
        if (triangle_count_ < LargeTriangles::kLeastSceneTriangles) return;
        const std::vector<TraceTriangle> largest = largest_triangles(LargeTriangles::kTriangles);
        if (!largest.empty()) large_triangles_.emplace(device_.get(), largest, !has_instances_);
    });
    return large_triangles_ ? &*large_triangles_ : nullptr;
}

bool EmbreeScene::triangles_near(const glm::dvec3& centre, double radius_m, std::size_t limit,
                                 const std::vector<char>& counted,
                                 std::vector<TraceTriangle>& triangles) const {
    struct Search {
        const EmbreeScene& scene;
        const glm::dvec3& centre;
        double radius_m;
        std::size_t limit;
        const std::vector<char>& counted;
        std::vector<TraceTriangle>& found;
        std::vector<std::uint64_t> names = {};  // of those found: trees may hold parts of one triangle
        bool complete = true;
    };
    triangles.clear();
    Search search{*this, centre, radius_m, limit, counted, triangles};
    const glm::vec3 c(centre);
    // Rounded outwards, so that nothing within the radius is missed: what lies beyond is told apart exactly.
    const double rounding_m = glm::distance(centre, glm::dvec3(c)) + kSearchMarginPart * diagonal_m_;
    RTCPointQuery query{};
    query.x = c.x;
    query.y = c.y;
    query.z = c.z;
    query.radius = static_cast<float>((radius_m + rounding_m) * (1 + 1e-5));
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto visit = [](RTCPointQueryFunctionArguments* args) {
        auto& s = *static_cast<Search*>(args->userPtr);
        const unsigned id = args->context->instStackSize > 0 ? args->context->instID[0] : args->geomID;
        const Placement& placement = s.scene.placements_[id];
        if (s.counted[placement.number] == 0) return false;
        const TraceTriangle triangle = s.scene.triangle(placement, args->primID);
        if (triangle.distance(s.centre) > s.radius_m) return false;
        const std::uint64_t name = std::uint64_t{id} << 32 | args->primID;
        if (std::ranges::find(s.names, name) != s.names.end()) return false;
        if (s.found.size() == s.limit) {
            s.complete = false;
            args->query->radius = 0;  // ends the search
            return true;
        }
        s.names.push_back(name);
        s.found.push_back(triangle);
        return false;
    };
    rtcPointQuery(scene_.get(), &query, &context, visit, &search);
    return search.complete;
}

}  // namespace aoscore
