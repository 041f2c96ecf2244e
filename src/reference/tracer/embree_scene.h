#pragma once

#include "reference/tracer/embree_handles.h"
#include "reference/tracer/trace_triangle.h"
#include "reference/tracer/walls.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstddef>
#include <deque>
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

/// The point of a triangle that a pixel sees, in trace space and double precision.
struct SurfaceHit {
    glm::dvec3 position;
    glm::dvec3 normal;          ///< geometric, unit, turned to the camera
    glm::dvec3 shading_normal;  ///< smooth, unit, on the same side
    double depth = 0;           ///< view depth -z, metres
    bool front = false;         ///< seen from the side that the triangle's winding calls the front (glTF 2.0)
    /// How far along the normal a ray must start so that rounding cannot make it meet the surface it leaves.
    double offset_m = 0;
};

/// A scene in Embree's hands. Trace space is scene space moved so that the scene's centre is its zero:
/// float32 keeps its digits for the scene's own extent, wherever the scene lies. Meshes are baked into trace
/// space until `baked_triangles_at_most` is spent; shared meshes beyond it stay instances.
class EmbreeScene {
  public:
    /// `wanted`: one flag an instance of the scene; those of 0 are left out, all else is as with the whole
    /// scene. Empty: all of them.
    EmbreeScene(const Scene& scene, const TraceBuild& build, const std::vector<char>& wanted = {});
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene handle() const { return scene_.get(); }
    const glm::dvec3& centre() const { return centre_; }
    double diagonal_m() const { return diagonal_m_; }
    std::size_t triangle_count() const { return triangle_count_; }  ///< of all instances, wanted or not
    std::size_t peak_bytes() const { return memory_.peak; }
    /// A context for packets of rays of similar direction. Embree 3.13.5 may never return from coherent
    /// packets that enter an instance, so that scenes with instances are traced as if packets were not.
    RTCIntersectContext packet_context() const;

    /// The scene's largest triangles by themselves; null where they are too large a part of it to be worth
    /// it. Built when first asked for.
    const Walls* walls() const;

    /// What the ray (scene space, unnormalised: t is view depth) meets first with t in [near, far].
    bool first_hit(const CameraFrame::Ray& ray, double near, double far, SurfaceHit& hit) const;

    /// The unit normal, trace space, of a hit that Embree reports with these ids and this Ng; 0 for a
    /// degenerate one.
    glm::dvec3 hit_normal(unsigned geometry_id, unsigned instance_id, const glm::dvec3& ng) const;

    /// All triangles within `radius_m` (infinity allowed) of a point of trace space, of the instances that
    /// are `counted` (one flag an instance of the scene); false when there are more than `limit` of them,
    /// which then may not all be there. Which they are does not depend on how the scene is laid out in trees.
    bool triangles_near(const glm::dvec3& centre, double radius_m, std::size_t limit,
                        const std::vector<char>& counted, std::vector<TraceTriangle>& triangles) const;

  private:
    struct Placement {
        const TraceGeometry* geometry = nullptr;
        glm::dmat4 trace_from_geometry{1.0};
        bool is_instance = false;
        std::size_t number = 0;  ///< of its instance in the Scene
        bool mirrors = false;    ///< that instance turns the winding round (glTF 2.0, "Instantiation")
    };
    TraceTriangle triangle(const Placement& placement, unsigned index) const;
    /// Those that are solid, in trace space and no instance's: they can be asked for by themselves.
    std::vector<TraceTriangle> largest_triangles(std::size_t count) const;
    struct Memory {
        std::atomic<std::ptrdiff_t> current{0};
        std::atomic<std::size_t> peak{0};
    };

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
    std::deque<TraceGeometry> geometries_;
    std::vector<Placement> placements_;  // by geometry id in scene_
    glm::dvec3 centre_{0};
    double diagonal_m_ = 0;
    std::size_t triangle_count_ = 0;
    bool has_instances_ = false;  // beside what is baked, wanted or not
    mutable std::once_flag walls_asked_for_;
    mutable std::optional<Walls> walls_;
};

}  // namespace aoscore
