#pragma once

#include "oracle.h"

#include <functional>

/// The papers' estimators, each evaluated by dense sampling at one point of a height field. Lengths in
/// metres; the settings are those of oracle_test.cpp.
namespace aoscore::testing::formula {

inline constexpr double kRadius = 0.4;
inline constexpr double kPixel = 0.01;

using oracle::Field;
using oracle::Point;
using oracle::Random;

/// GLSL's smoothstep.
double smooth_step(double low, double high, double x);

/// V = 1 - the mean occlusion at points P + frame · draw() · R; `weight` depends on the drawn offset and the
/// surface's z.
double point_test(const Field& field, const Point& point, const std::function<glm::dvec3(Random&)>& draw,
                  const std::function<double(const glm::dvec3& offset, double surface_z)>& weight,
                  double bias = 0);
double always(const glm::dvec3&, double);
/// Scales a direction by a random distance, so that the points fill the ball evenly.
glm::dvec3 in_volume(const glm::dvec3& direction, Random& random);

double alchemy(const Field& field, const Point& point, double sigma, double kappa);
double sao(const Field& field, const Point& point);
double cacao(const Field& field, const Point& point);
double sphere_caps(const Field& field, const Point& point);
double volumetric(const Field& field, const Point& point, bool hemisphere);
double tangent_sphere(const Field& field, const Point& point);
double hbao(const Field& field, const Point& point, double bias);
/// Hussain's HBAO with steps of `step` metres.
double hbao_hussain(const Field& field, const Point& point, double step, int steps);
double hbao_plus(const Field& field, const Point& point);
double gtao(const Field& field, const Point& point);
double xegtao(const Field& field, const Point& point);
/// For solid surfaces a slice is open between its horizons.
double uniform_sectors(const Field& field, const Point& point);
double ray_march(const Field& field, const Point& point);

}  // namespace aoscore::testing::formula
