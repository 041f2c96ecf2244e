#pragma once

#include "reference/estimate/open_cone.h"
#include "reference/tracer/ray_observer.h"
#include "reference/truth.h"

#include <vector>

namespace aoscore {

/// Sums the open directions of each pixel over rays that are uniform over its hemisphere.
class OpenDirections final : public RayObserver {
  public:
    explicit OpenDirections(const TruthQuery& query) : query_(query) {}

    void start(std::size_t sources) override { sums_.assign(sources, {}); }
    void observe(std::size_t source, const ObservedRay& ray) override;
    const OpenSums& sums(std::size_t source) const { return sums_[source]; }

  private:
    const TruthQuery& query_;
    std::vector<OpenSums> sums_;
};

}  // namespace aoscore
