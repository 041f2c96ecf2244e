#pragma once

#include "core/ratio_table.h"
#include "scene/scene.h"

#include <cstdint>

namespace aoscore {

/// Rows of what a pass of S depth layers costs beside S plain depth passes, and prints what methods find by
/// them on a view: for each method that reads depth layers, by S, how much of what one layer hides from it it
/// finds again, of all that the same method finds over all layers peeled off, as it is and at the strength at
/// which it occludes as much as with one layer where nothing is hidden.
void bench_layers(const Scene& scene, const View& view, std::uint64_t seed, RatioTable& table);

}  // namespace aoscore
