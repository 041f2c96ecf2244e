#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <numbers>
#include <vector>

namespace aoscore::builtin {

/// Edges between faces that turn by more than this stay sharp.
inline constexpr double kCrease_rad = 40.0 * std::numbers::pi / 180.0;

/// Collects triangles in double precision, metres, counter-clockwise seen from the visible side, and turns
/// them into a Mesh: equal positions welded, triangles without area dropped, smooth unit normals within the
/// crease angle.
class MeshBuilder {
  public:
    using Point = glm::dvec3;
    struct Corner {
        Point position;
        glm::vec2 uv{0};
    };

    void triangle(const Point& a, const Point& b, const Point& c);
    void triangle(const Point& a, const Point& b, const Point& c, const glm::vec2& uv_a,
                  const glm::vec2& uv_b, const glm::vec2& uv_c);
    /// Adds a quadrilateral, split along a-c.
    void quad(const Point& a, const Point& b, const Point& c, const Point& d);
    /// Adds all triangles of another builder, moved. A mirroring matrix is not allowed.
    void append(const MeshBuilder& other, const glm::dmat4& this_from_other);

    /// `with_texcoords` keeps the texture coordinates (0,0 where none were given).
    Mesh finish(int material, double crease_rad = kCrease_rad, bool with_texcoords = false) const;

  private:
    std::vector<Corner> corners_;  // three corners a triangle
};

}  // namespace aoscore::builtin
