#include "reference/tracer/embree/first_triangles.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace aoscore {
namespace {

/// Triangles that lie this part of their distance behind the first count as met at once: many times what
/// float32 rounds, except where a surface is seen flat.
constexpr float kTiePart = 1e-5f;
/// The search goes on beyond that, since boxes of trees are rounded too.
constexpr float kSearchPart = 2 * kTiePart;

struct Search {
    float far;
    float nearest = std::numeric_limits<float>::infinity();
    std::vector<MetTriangle> met = {};
};

/// How Embree brings a search to its filter.
struct SearchContext : RTCIntersectContext {
    Search* search;
};

/// Notes a triangle, and lets the ray go on to what lies a little behind the nearest.
void note(const RTCFilterFunctionNArguments* args) {
    Search& search = *static_cast<const SearchContext*>(args->context)->search;
    const unsigned instance = RTCHitN_instID(args->hit, args->N, 0, 0);
    const unsigned geometry = RTCHitN_geomID(args->hit, args->N, 0);
    float& end = RTCRayN_tfar(args->ray, args->N, 0);
    search.met.push_back({instance != RTC_INVALID_GEOMETRY_ID ? instance : geometry,
                          RTCHitN_primID(args->hit, args->N, 0), end, RTCHitN_u(args->hit, args->N, 0),
                          RTCHitN_v(args->hit, args->N, 0)});
    search.nearest = std::min(search.nearest, end);
    end = std::min(search.far, search.nearest * (1 + kSearchPart));
}

}  // namespace

std::vector<MetTriangle> first_triangles(RTCScene scene, const RTCRay& ray) {
    Search search{ray.tfar};
    SearchContext context;
    rtcInitIntersectContext(&context);
    context.filter = note;
    context.search = &search;
    RTCRayHit query{};
    query.ray = ray;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &query);
    const float last = search.nearest * (1 + kTiePart);
    std::erase_if(search.met, [&](const MetTriangle& met) { return met.distance > last; });
    return std::move(search.met);
}

}  // namespace aoscore
