#include "reference/tracer/embree/large_triangles.h"

namespace aoscore {

LargeTriangles::LargeTriangles(RTCDevice device, std::span<const TraceTriangle> triangles, bool coherent)
    : scene_(new_trace_scene(device, TreeEffort::thorough)), coherent_(coherent) {
    GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_HIGH);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX,
                                                                     0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                                                     3 * triangles.size()));
    auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.size()));
    check_embree(device, "storing a scene's largest triangles");
    unsigned next = 0;
    for (const TraceTriangle& triangle : triangles) {
        for (const glm::dvec3& corner : triangle.corners) *vertices++ = glm::vec3(corner);
        *indices++ = glm::uvec3(next, next + 1, next + 2);
        next += 3;
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
    rtcCommitScene(scene_.get());
    check_embree(device, "building a scene of its largest triangles");
}

}  // namespace aoscore
