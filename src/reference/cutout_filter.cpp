#include "reference/cutout_filter.h"

namespace aoscore {
namespace {

bool is_hole(const TraceGeometry& geometry, unsigned triangle, float u, float v) {
    const glm::uvec3 corner = geometry.triangles[triangle];
    const glm::vec2 uv = geometry.texcoords.empty()
                             ? glm::vec2(0)
                             : (1 - u - v) * geometry.texcoords[corner.x] + u * geometry.texcoords[corner.y] +
                                   v * geometry.texcoords[corner.z];
    return alpha_at(*geometry.cutouts, *geometry.material, uv) < geometry.material->alpha_cutoff;
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
