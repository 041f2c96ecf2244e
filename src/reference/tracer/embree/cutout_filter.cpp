#include "reference/tracer/embree/cutout_filter.h"

namespace aoscore {
namespace {

template <class T>
T interpolated(const std::vector<T>& values, const T& without, const glm::uvec3& corner, float u, float v) {
    if (values.empty()) return without;
    return (1 - u - v) * values[corner.x] + u * values[corner.y] + v * values[corner.z];
}

bool is_hole(const TraceGeometry& geometry, unsigned triangle, float u, float v) {
    const glm::uvec3 corner = geometry.triangles[triangle];
    const glm::vec2 uv = interpolated(geometry.texcoords, glm::vec2(0), corner, u, v);
    const float vertex_alpha = interpolated(geometry.alphas, 1.0f, corner, u, v);
    return alpha_at(*geometry.cutouts, *geometry.material, uv, vertex_alpha) <
           geometry.material->alpha_cutoff;
}

void reject_holes(const RTCFilterFunctionNArguments* args) {
    const auto& geometry = *static_cast<const TraceGeometry*>(args->geometryUserPtr);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] != -1) continue;
        if (is_hole(geometry, RTCHitN_primID(args->hit, args->N, lane), RTCHitN_u(args->hit, args->N, lane),
                    RTCHitN_v(args->hit, args->N, lane))) {
            args->valid[lane] = 0;
        }
    }
}

}  // namespace

void set_cutout_filter(RTCGeometry geometry) {
    rtcSetGeometryIntersectFilterFunction(geometry, reject_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, reject_holes);
}

}  // namespace aoscore
