#pragma once

#include "scene/scene.h"

#include <string>

namespace aoscore {

/// How far from the middle of a scene a camera and its target may be, in diagonals of the scene's bounds.
inline constexpr double kFurthestCamera = 1000;

/// Whether float32 can hold the number, to its precision.
bool is_float32(double value);

/// Why pictures cannot be made with this camera of a scene with these bounds (in the same coordinates), and
/// what would be valid: numbers that are no finite float32, which is what rays and matrices are made of, or a
/// place so far away that float32 could not tell the scene's parts apart. Empty where they can.
std::string view_fault(const Camera& camera, const Bounds& bounds);

}  // namespace aoscore
