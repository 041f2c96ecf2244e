#pragma once

#include "scene/scene.h"

namespace aoscore {

/// Other triangles for the same surfaces. Corners are made in double precision and stored as float32, as any
/// file would have them.

/// Every triangle in four, again and again, until no edge is longer than `edge_m`.
void split_to_edges(Scene& scene, double edge_m);
/// Every triangle as a fan of `count` needles, or of as many as leave a mesh no more than `most_triangles`.
void split_to_needles(Scene& scene, int count, std::size_t most_triangles);
/// Adds triangles without area along every edge: two corners the same, and three on one line.
void add_triangles_without_area(Scene& scene);
/// Every surface twice: the second time moved outwards by `offset_m`; `split` in four triangles each.
void add_surfaces_again(Scene& scene, double offset_m, bool split);

}  // namespace aoscore
