#pragma once

#include "reference/estimate/pixel_spread.h"
#include "reference/estimate/tile_law.h"

#include <span>
#include <vector>

namespace aoscore {

/// A pixel's visibility and its standard error.
struct Estimate {
    double visibility = 1;
    double standard_error = 0;
};

/// The standard error of a pixel whose `samples` (>= 1) rays all agree, where of the `alike` pixels of its
/// tile that see mostly the same `agreeing` (1 to `alike`) agree as well. With x = -log(agreeing / alike),
/// the rays that independent pixels would miss, the true error was seen to follow one curve of x over N on
/// every scene, whatever N. What is stated lies a little above it, where the few that miss an occluder have
/// their errors; as long as little is known of the tile, one pixel in four is believed to agree.
double error_of_agreement(int samples, int agreeing, int alike);

/// Standard errors of the pixels of one tile. A pixel's own blocks have few degrees of freedom, so that its
/// variance is drawn towards the law of its tile and neighbours, as Smyth (Linear Models and Empirical Bayes
/// Methods for Assessing Differential Expression, 2004) does for genes. Pixels whose rays all agree state
/// error_of_agreement(), those of a single ray the spread of their tile.
///
/// Meant to hold in the tail: over many seeds and scenes fewer than 1 pixel in 200 errs by more than three
/// times what it states, and the root mean square of what is stated is that of the true errors within 5 %
/// (scene by scene within 20 %, mostly too large).
std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels, const TileLawRules& rules);

}  // namespace aoscore
