#pragma once

#include "reference/estimate/estimate.h"
#include "reference/estimate/open_cone.h"
#include "reference/integrator/tile.h"
#include "reference/tracer/hit_observer.h"
#include "reference/truth.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace aoscore {

/// Everything that was traced of one tile: its pixels of a truth follow from it without a ray, and more rays
/// can be added to it. All sums are exact (see kOcclusionStep), so that it does not matter in how many rounds
/// they came together.
struct TileState {
    std::vector<std::uint16_t> places;   ///< of the tile's pixels with a surface, counted row by row
    std::vector<float> depths_m;         ///< of those surfaces, as in PrimaryHits
    std::vector<glm::vec3> normals;      ///< of those surfaces, as in PrimaryHits
    std::vector<std::uint32_t> samples;  ///< rays of those surfaces; 0: proven open
    /// Occlusion by query, then surface, then as TileTracer::sums() has it; multiples of kOcclusionStep.
    std::vector<double> sums;
    std::vector<HitObserver::Sums> extras;  ///< of those surfaces; empty unless TruthExtras asks for some
    std::vector<OpenSums> open_sums;        ///< of those surfaces; empty unless bent normals are asked for

    std::size_t surfaces() const { return places.size(); }
    std::span<const double> sums_of(std::size_t query, std::size_t queries, std::size_t surface) const;
    bool operator==(const TileState&) const = default;
};

/// Where TileState::places has a pixel of this tile.
inline PlaceInTile place_in(const Tile& tile, std::uint16_t place) {
    const int columns = tile.x1 - tile.x0;
    return {place % columns, place / columns};
}

/// Estimates for `query` of the pixels at these places, which have so many rays each, traced with these
/// settings; `sums(i)` are the sums of pixel i.
std::vector<Estimate> stated_estimates(std::span<const PlaceInTile> places, std::span<const int> samples,
                                       const TruthQuery& query, const TruthSettings& settings,
                                       const std::function<std::span<const double>(std::size_t)>& sums);

/// Standard errors by query, then pixel of those pixels of the tile that got rays; it was traced for these
/// queries.
std::vector<std::vector<double>> stated_errors(const Tile& tile, const TileState& state,
                                               const std::vector<TruthQuery>& queries,
                                               const TruthSettings& settings);

/// The queries that a tile was traced for, and which of its queries are wanted: truth.queries[i] is number
/// which[i].
struct ResolveRequest {
    std::size_t queries;
    std::span<const std::size_t> which;
    const TruthSettings& settings;
};

/// Fills the tile's pixels of all images that `truth` has.
void resolve_tile(const Tile& tile, const TileState& state, const CameraFrame& frame,
                  const ResolveRequest& request, Truth& truth);

}  // namespace aoscore
