#pragma once

#include "scene/scene.h"

namespace aoscore {

/// These functions make other triangles for the same surfaces. Corners are computed in double precision and
/// stored as float32, as in any file.

/// Splits every triangle in four, repeatedly, until no edge is longer than `edge_m`.
void split_to_edges(Scene& scene, double edge_m);
/// Splits every triangle into a fan of `count` needles, or of fewer where a mesh would exceed
/// `most_triangles`.
void split_to_needles(Scene& scene, int count, std::size_t most_triangles);
/// Adds triangles without area along every edge: with two equal corners, and with three on one line.
void add_triangles_without_area(Scene& scene);
/// Adds every surface again, moved outwards by `offset_m`; `split` divides its triangles in four.
void add_surfaces_again(Scene& scene, double offset_m, bool split);

}  // namespace aoscore
