#pragma once

#include "reference/integrator/tile.h"
#include "reference/integrator/tile_state.h"
#include "reference/integrator/tile_store.h"
#include "reference/truth.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// No surface anywhere.
PrimaryHits empty_hits(int width, int height);

/// All open, no surface anywhere, with room for these extras.
Truth empty_truth(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                  const TruthExtras& extras);

/// Fills in the counts that follow from the truth's sample_counts.
void count_samples(const TruthSettings& settings, Truth& truth);

/// 0, 1, ..., count - 1.
std::vector<std::size_t> numbers_up_to(std::size_t count);

/// Resolves all tiles of group number `g`.
void resolve_group(const TileGroups& groups, std::size_t g, const std::vector<TileState>& tiles,
                   const CameraFrame& frame, const ResolveRequest& request, Truth& truth);

/// Resolves those groups that are kept; their seconds, divided among the threads, are added to the truth's.
void resolve_kept(const TileGroups& groups, const std::vector<std::size_t>& kept, const TileStore& store,
                  const CameraFrame& frame, const ResolveRequest& request, Truth& truth);

}  // namespace aoscore
