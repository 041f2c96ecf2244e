#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <random>

namespace aoscore::testing {

/// Double-precision evaluations of the papers' formulas on a height field, by dense sampling, independent of
/// every shader: an orthographic camera looks down -z, so a field's z(x, y) is its depth buffer.
namespace oracle {

struct Field {
    std::function<double(double, double)> z;
    double footprint = 0;  ///< a pixel's, in metres
};
struct Point {
    glm::dvec3 p{0};
    glm::dvec3 n{0, 0, 1};  ///< unit, n.z > 0
};

/// The point of the surface at an offset.
inline glm::dvec3 surface(const Field& field, double x, double y) {
    return {x, y, field.z(x, y)};
}

/// The frame of tangent, bitangent and normal.
glm::dmat3 basis(const glm::dvec3& n);

using Random = std::mt19937_64;
double unit(Random& random);
glm::dvec3 sphere_direction(Random& random);
glm::dvec3 cube_direction(Random& random);        ///< a point of the cube, normalised
glm::dvec3 hemisphere_direction(Random& random);  ///< uniform, z >= 0
glm::dvec3 cosine_direction(Random& random);      ///< z >= 0
glm::dvec2 disc_point(Random& random);

/// The mean of `value(random)` over `count` draws.
double mean(int count, const std::function<double(Random&)>& value);

/// The mean of `value(S - P)` over offsets that fill a disc of this radius around the point evenly.
double disc_mean(const Field& field, const Point& point, double radius,
                 const std::function<double(const glm::dvec3& v)>& value);

/// Whether the surface hides a view-space point.
bool hidden(const Field& field, const glm::dvec3& s, double bias);

/// Both horizons of the slice through the view vector at this azimuth, cosines to the view vector, from
/// samples that `weight` (of the distance) blends toward the tangent plane's; then the angle of the projected
/// normal and its length.
struct Slice {
    double gamma = 0, normal_length = 0, h0 = 0, h1 = 0;
};
Slice slice(const Field& field, const Point& point, double azimuth, double radius,
            const std::function<double(double)>& weight);
/// Slice visibility with the cosine weight, by numerical integration of cos(t - gamma) |sin t| over the open
/// angles.
double slice_visibility(const Slice& slice);

}  // namespace oracle
}  // namespace aoscore::testing
