#pragma once

#include "reference/tracer/ray_packet.h"
#include "reference/tracer/trace_triangle.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace aoscore {

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

/// Triangles that may block rays. Packets are asked about one at a time, so that a call costs nothing beside
/// the sixteen rays.
class Occluders {
  public:
    Occluders() = default;
    Occluders(const Occluders&) = delete;
    Occluders& operator=(const Occluders&) = delete;
    virtual ~Occluders() = default;

    /// Makes the reach of those of the first `lanes` rays negative that meet something within it.
    virtual void mark_blocked(RayPacket& packet, std::size_t lanes) const = 0;
};

/// A scene, built for tracing. Trace space is scene space moved so that the scene's centre is its zero:
/// float32 keeps its digits for the scene's own extent, wherever the scene lies. All threads may ask at once.
///
/// Implementations:
///   EmbreeScene (embree/embree_scene.h)  Intel Embree 3, on the processor
class RayTracer : public Occluders {
  public:
    /// The zero of trace space, in scene space.
    virtual const glm::dvec3& centre() const = 0;
    virtual double diagonal_m() const = 0;
    virtual std::size_t triangle_count() const = 0;  ///< of all instances, whether built or not
    virtual std::size_t peak_bytes() const = 0;

    /// Finds the first hit of the ray (scene space, unnormalised: t is view depth) with t in [near, far].
    /// Where float32 cannot tell which of several surfaces comes first, as where they meet, it is the one
    /// that double precision finds nearest: the same one however the scene is laid out in trees.
    virtual bool first_hit(const CameraFrame::Ray& ray, double near, double far, SurfaceHit& hit) const = 0;

    virtual bool occluded(const TraceRay& ray) const = 0;
    /// Finds the ray's first hit; false where it meets nothing.
    virtual bool nearest(const TraceRay& ray, TraceHit& hit) const = 0;

    /// Finds the first hits of the first `lanes` rays: one bit for each that meets something. Their distances
    /// do not depend on how the scene is laid out in trees; which triangle a ray names of two at the very
    /// same float32 distance may.
    virtual std::uint32_t nearest(const RayPacket& packet, std::size_t lanes, HitPacket& hits) const = 0;
    /// The unit normal, trace space, of a lane that met something; 0 of a degenerate triangle. Not made for
    /// every lane, because most truths need none.
    virtual glm::dvec3 normal(const HitPacket& hits, std::size_t lane) const = 0;

    /// The scene's largest triangles by themselves, which are quicker to ask and block most far rays; null
    /// where it would not pay. Built when first asked for.
    virtual const Occluders* large_triangles() const = 0;

    /// All triangles within `radius_m` (infinity allowed) of a point of trace space, of the instances that
    /// are `counted` (one flag an instance of the scene); false when there are more than `limit` of them,
    /// which then may not all be there. Which they are does not depend on how the scene is laid out in trees.
    virtual bool triangles_near(const glm::dvec3& centre, double radius_m, std::size_t limit,
                                const std::vector<char>& counted,
                                std::vector<TraceTriangle>& triangles) const = 0;
};

/// How much work goes into a tree before rays are traced in it.
enum class TreeEffort {
    quick,     ///< built a quarter sooner, where triangles are long and thin, and up to 4 % slower to trace
    thorough,  ///< triangles are divided between branches where that spares rays work
};

/// What takes less time in all for so many triangles in trees and so many rays: the bits are the same. On
/// hairball, a million triangles in one mesh, a quick tree spares 0.16 s of 0.78 s, about as much as 16 rays
/// a triangle cost more in it: 5 % of a whole truth at 320x180 and 16 rays a pixel, nothing at 640x360. On
/// atrium, courtyard and Sponza (262,267 triangles in many meshes), whose trees take 0.03 to 0.12 s, both
/// take the same to build and to trace. Embree's lowest quality spares 0.6 s on hairball and 0.07 s on
/// Sponza, but rays take 2.4 and 1.25 times as long, so that it never pays from 16 rays a pixel on.
TreeEffort tree_effort(std::uint64_t triangles, double rays);

/// The one place that chooses an implementation. `wanted`: one flag an instance of the scene; those of 0 are
/// left out, all else is as with the whole scene. Empty: all of them. `rays`: how many there will be, as far
/// as that is known, see tree_effort(). Throws internal_error.
std::unique_ptr<RayTracer> new_ray_tracer(const Scene& scene, const TraceBuild& build,
                                          const std::vector<char>& wanted = {},
                                          double rays = std::numeric_limits<double>::infinity());

}  // namespace aoscore
