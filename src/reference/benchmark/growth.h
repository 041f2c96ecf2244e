#pragma once

#include "reference/benchmark/benchmark.h"

namespace aoscore {

/// Prints how the time of a truth of the first radius grows with pixels, and with triangles: of the same
/// scene, each of its triangles cut into four, and again.
void print_growth(const Scene& scene, const ReferenceScene& reference, const Camera& camera,
                  const ReferenceBenchmark& benchmark);

}  // namespace aoscore
