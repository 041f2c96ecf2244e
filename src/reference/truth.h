#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/image.h"
#include "scene/scene.h"

namespace aoscore {

/// How much a hit at distance t darkens, g(t) in [0,1]; visibility is the mean of 1 - g over cosine-weighted rays.
enum class Falloff {
    binary,     ///< 1 within the radius (ambient occlusion proper)
    quadratic,  ///< 1 - (t/R)^2 within R (Bavoil, Sainz, Image-Space Horizon-Based Ambient Occlusion, 2008)
    alchemy,    ///< u t / max(u, t)^2, never 0 (McGuire et al., The Alchemy Screen-Space Ambient Obscurance Algorithm, 2011)
};

/// One truth to be read from a set of rays.
struct TruthQuery {
    Falloff falloff = Falloff::binary;
    double radius_m = 1.0;  ///< > 0, infinity allowed
    double u_m = 0;         ///< alchemy only: its u, metres, > 0
    bool operator==(const TruthQuery&) const = default;
};

struct TruthSettings {
    int samples = 64;             ///< rays a pixel, >= 1
    std::uint64_t seed = 1;
    bool shading_normals = false; ///< hemisphere about the smooth normal instead of the geometric one
};

/// What each pixel centre sees: the same quantities as the rasterised G-buffer, for the camera contract.
struct PrimaryHits {
    Mask surface;               ///< 1 where a surface lies between the near and far plane
    ImageF depth;               ///< view depth -z, metres; 0 without surface
    Image<glm::vec3> normal;    ///< geometric, view space, unit, turned to the camera; 0 without surface
};

/// Ray-traced visibility of every pixel, and how sure of it we are.
struct Truth {
    PrimaryHits hits;
    std::vector<TruthQuery> queries;
    std::vector<ImageF> visibility;      ///< one image a query, in [0,1]; 1 where there is no surface
    std::vector<ImageF> standard_error;  ///< one image a query, > 0 on surfaces; 0 where there is none
    int samples = 0;                     ///< rays a pixel (the mean, if they differ)
    std::uint64_t rays = 0;              ///< occlusion rays traced
    double seconds = 0;                  ///< tracing only
};

/// A scene built for Embree; builds once, serves any number of views.
class ReferenceScene {
  public:
    explicit ReferenceScene(const Scene& scene);
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;

    PrimaryHits primary_hits(const CameraFrame& frame) const;

    /// Integrates all queries from the same rays. The same image for any thread count. `what` names the work for
    /// its progress bar. Throws interrupted_error on Ctrl-C, usage_error for settings out of range.
    Truth trace(const CameraFrame& frame, const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                const std::string& what) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aoscore
