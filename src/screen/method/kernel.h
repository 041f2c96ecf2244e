#pragma once

#include "core/image.h"
#include "screen/method/method.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The choices for the members of a descriptor's kernel.
///   directions: "sphere" uniform; "sphere_cube" a uniform point of the cube [-1,1]^3, normalised (denser
///   toward
///     its corners, as widely copied code has it); "hemisphere_cube" the same of [-1,1]²x[0,1]; "hemisphere"
///     uniform, z >= 0; "hemisphere_cosine" density proportional to z (Malley); "disc" uniform angle, z = 0.
///   radii: "shell" 1; "uniform" in [0,1); "volume" so that the points fill the ball (or disc) evenly.
///   scale: "none"; "squared" lerp(0.1, 1, (i/N)²) pulls the first points inward; "squared_of_64" the same
///   with 64
///     for N, whatever N is.
///   sequence: "random"; "low_discrepancy" (additive recurrence of the plastic number's kin, Roberts 2018).
struct KernelChoices {
    static const std::set<std::string>& directions();
    static const std::set<std::string>& radii();
    static const std::set<std::string>& scales();
    static const std::set<std::string>& sequences();
};

/// Generates the points of a kernel whose members are all values (no '@'). The points depend on the arguments
/// alone, on every machine. A longer "random" or "low_discrepancy" kernel begins with the points of a shorter
/// one, up to `scale`.
std::vector<glm::vec3> generate_kernel(const Kernel& kernel, std::uint64_t seed);

/// Generates the 4x4 tile of noise: four numbers in [0,1) a pixel. Each channel is a permutation of (i +
/// ½)/16, so that the mean over any aligned or unaligned 4x4 block is exactly stratified.
Image<glm::vec4> generate_noise_4x4(std::uint64_t seed);

}  // namespace aoscore
