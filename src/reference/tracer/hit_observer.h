#pragma once

#include "reference/tracer/ray_batch.h"
#include "reference/tracer/ray_observer.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"

#include <array>
#include <vector>

namespace aoscore {

/// Tells by where a hit lies for the camera why one depth layer would miss it.
class CauseJudge {
  public:
    /// `hits` is the whole picture that the camera sees.
    CauseJudge(const RayTracer& scene, const CameraFrame& frame, const PrimaryHits& hits)
        : scene_(scene), frame_(frame), hits_(hits) {}

    /// Of a hit at `position` on a surface of unit normal `normal`, trace space.
    Cause judge(const glm::dvec3& position, const glm::dvec3& normal) const;

  private:
    const RayTracer& scene_;
    const CameraFrame& frame_;
    const PrimaryHits& hits_;
};

/// Gathers over the rays of a tile's pixels what TruthExtras asks for of their hits.
class HitObserver final : public RayObserver {
  public:
    HitObserver(const RayTracer& scene, const CauseJudge& judge, const TruthQuery& query,
                const TruthExtras& extras)
        : scene_(scene), judge_(judge), query_(query), extras_(extras) {}

    /// Sums over the rays of one pixel.
    struct Sums {
        std::array<double, kCauses> by_cause{};
        double one_layer = 0;
        bool operator==(const Sums&) const = default;
    };

    void start(std::size_t sources) override { sums_.assign(sources, {}); }
    void observe(std::size_t source, const ObservedRay& ray) override;
    /// Goes on from sums of an earlier trace; after start().
    void restore(std::size_t source, const Sums& sums) { sums_[source] = sums; }
    const Sums& sums(std::size_t source) const { return sums_[source]; }

  private:
    /// g of the nearest visible hit at or beyond the nearest hit, 0 without one.
    double first_visible(const ObservedRay& ray, Cause nearest) const;

    const RayTracer& scene_;
    const CauseJudge& judge_;
    const TruthQuery& query_;
    TruthExtras extras_;
    std::vector<Sums> sums_;
};

}  // namespace aoscore
