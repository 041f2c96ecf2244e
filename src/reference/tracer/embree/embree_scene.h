#pragma once

#include "reference/tracer/embree/embree_handles.h"
#include "reference/tracer/embree/embree_packets.h"
#include "reference/tracer/embree/first_triangles.h"
#include "reference/tracer/embree/large_triangles.h"
#include "reference/tracer/ray_tracer.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

namespace aoscore {

/// The triangles of one Embree geometry, as Embree sees them, in its own space.
struct TraceGeometry {
    const glm::vec3* vertices = nullptr;    ///< owned by Embree
    const glm::uvec3* triangles = nullptr;  ///< owned by Embree
    unsigned triangle_count = 0;
    std::vector<glm::vec3> normals;      ///< smooth, unit, one a vertex; empty: flat
    std::vector<glm::vec2> texcoords;    ///< one a vertex; cut-outs only
    std::vector<float> alphas;           ///< one a vertex; cut-outs only, empty: 1
    const Material* material = nullptr;  ///< cut-outs only
    const Scene* cutouts = nullptr;      ///< textures of the cut-outs
};

/// A scene in Embree's hands. Meshes are baked into trace space until `baked_triangles_at_most` is spent;
/// shared meshes beyond it stay instances.
class EmbreeScene final : public RayTracer {
  public:
    /// As new_ray_tracer().
    EmbreeScene(const Scene& scene, const TraceBuild& build, const std::vector<char>& wanted = {},
                double rays = std::numeric_limits<double>::infinity());

    const glm::dvec3& centre() const override { return centre_; }
    double diagonal_m() const override { return diagonal_m_; }
    std::size_t triangle_count() const override { return triangle_count_; }
    std::size_t peak_bytes() const override { return memory_.peak; }

    bool first_hit(const CameraFrame::Ray& ray, double near, double far, SurfaceHit& hit) const override;
    bool occluded(const TraceRay& ray) const override;
    bool nearest(const TraceRay& ray, TraceHit& hit) const override;
    void mark_blocked(RayPacket& packet, std::size_t lanes) const override;
    std::uint32_t nearest(const RayPacket& packet, std::size_t lanes, HitPacket& hits) const override;
    glm::dvec3 normal(const HitPacket& hits, std::size_t lane) const override;
    const Occluders* large_triangles() const override;
    bool triangles_near(const glm::dvec3& centre, double radius_m, std::size_t limit,
                        const std::vector<char>& counted,
                        std::vector<TraceTriangle>& triangles) const override;

    /// For what measures Embree itself.
    RTCScene handle() const { return scene_.get(); }
    /// A context for packets of rays of similar direction. Embree 3.13.5 may never return from coherent
    /// packets that enter an instance, so that scenes with instances are traced as if packets were not.
    RTCIntersectContext packet_context() const { return context_of_packets(!has_instances_); }

  private:
    struct Placement {
        const TraceGeometry* geometry = nullptr;
        glm::dmat4 trace_from_geometry{1.0};
        bool is_instance = false;
        std::size_t number = 0;  ///< of its instance in the Scene
        bool mirrors = false;    ///< that instance turns the winding round (glTF 2.0, "Instantiation")
    };
    TraceTriangle triangle(const Placement& placement, unsigned index) const;
    /// The one that a ray (trace space) meets first, by double precision; there must be one.
    MetTriangle nearest_of(const std::vector<MetTriangle>& tied, const glm::dvec3& origin,
                           const glm::dvec3& direction) const;
    /// Those that are solid, in trace space and no instance's: they can be asked for by themselves.
    std::vector<TraceTriangle> largest_triangles(std::size_t count) const;
    struct Memory {
        std::atomic<std::ptrdiff_t> current{0};
        std::atomic<std::size_t> peak{0};
    };

    /// The same of one hit, by Embree's ids and its Ng.
    glm::dvec3 normal_at(unsigned placement, const glm::dvec3& ng) const;

    void copy_cutouts(const Scene& scene);
    TraceGeometry& add_triangles(RTCScene target, const Mesh& mesh, const glm::dmat4& transform);
    void add_instance(const TraceGeometry& geometry, RTCScene shared, const glm::dmat4& transform,
                      std::size_t number);
    static bool count_memory(void* memory, ssize_t bytes, bool post);

    Memory memory_;
    DeviceHandle device_;
    std::vector<SceneHandle> shared_;
    SceneHandle scene_;
    Scene cutouts_;  // materials, and the textures of cut-outs alone
    TreeEffort effort_ = TreeEffort::thorough;
    std::deque<TraceGeometry> geometries_;
    std::vector<Placement> placements_;  // by geometry id in scene_
    glm::dvec3 centre_{0};
    double diagonal_m_ = 0;
    std::size_t triangle_count_ = 0;
    bool has_instances_ = false;  // beside what is baked, wanted or not
    mutable std::once_flag walls_asked_for_;
    mutable std::optional<LargeTriangles> large_triangles_;
};

}  // namespace aoscore
