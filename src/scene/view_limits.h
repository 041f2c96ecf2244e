#pragma once

#include "scene/scene.h"

#include <string>

namespace aoscore {

/// The greatest distance of a camera and its target from the middle of a scene, in diagonals of its bounds.
inline constexpr double kFurthestCamera = 1000;

/// Whether float32 can hold the number, to its precision.
bool is_float32(double value);

/// Says why this camera cannot show a scene with these bounds (in the same coordinates), and what would be
/// valid: its numbers are no finite float32, which rays and matrices are made of, or it is so far away that
/// float32 could not tell the scene's parts apart. Empty where it can.
std::string view_fault(const Camera& camera, const Bounds& bounds);

}  // namespace aoscore
