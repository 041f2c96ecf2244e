#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

/// The mathematics of low-discrepancy points and of directions made from them. Small and inline: these run
/// once a ray.
namespace aoscore {

/// Bijective mixing of 64 bits: neighbouring inputs give unrelated outputs (Steele, Lea, Flood, Fast
/// Splittable Pseudorandom Number Generators, 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// The second coordinate of point `index` of the two-dimensional Sobol sequence (primitive polynomial x + 1),
/// as a fraction of 2^32, its bits in reverse order. The first coordinate's bits in reverse order are `index`
/// itself.
constexpr std::uint32_t sobol_y_reversed(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1; index != 0; index >>= 1, column ^= column << 1) {
        if ((index & 1u) != 0) result ^= column;
    }
    return result;
}

/// Nested uniform (Owen) scrambling of a coordinate whose bits come in reverse order; the result is in
/// natural order, a fraction of 2^32. Each step lets a bit depend only on itself and on the more significant
/// ones of the coordinate, which is what makes the permutation nested (Laine & Karras, Stratified Sampling
/// for Stochastic Transparency, 2011; Burley, Practical Hash-Based Owen Scrambling, 2020).
constexpr std::uint32_t owen_scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

/// A fraction of 2^32 as a float strictly inside (0, 1): the centre of one of 2^23 equal intervals.
constexpr float unit_interval(std::uint32_t bits) {
    return (static_cast<float>(bits >> 9) + 0.5f) * 0x1p-23f;
}

/// Maps (0,1)^2 to the unit disc, equal areas to equal areas, neighbours to neighbours (Shirley & Chiu, A Low
/// Distortion Map Between Disk and Square, 1997).
inline glm::vec2 concentric_disc(float u, float v) {
    const float a = 2 * u - 1, b = 2 * v - 1;
    const bool a_is_larger = std::abs(a) > std::abs(b);
    const float radius = a_is_larger ? a : b;
    const float other = a_is_larger ? b : a;
    const float angle = radius == 0 ? 0.0f : std::numbers::pi_v<float> / 4 * (other / radius);
    // Taylor polynomials, exact to a float's last place for |angle| <= pi/4: the same on every machine.
    const float q = angle * angle;
    const float sine =
        angle * (1 + q * (-1.0f / 6 + q * (1.0f / 120 + q * (-1.0f / 5040 + q * (1.0f / 362880)))));
    const float cosine = 1 + q * (-0.5f + q * (1.0f / 24 + q * (-1.0f / 720 + q * (1.0f / 40320))));
    return {radius * (a_is_larger ? cosine : sine), radius * (a_is_larger ? sine : cosine)};
}

/// A direction about +z with density cos/pi (Malley's method): unit, z > 0.
inline glm::vec3 cosine_hemisphere(float u, float v) {
    const glm::vec2 disc = concentric_disc(u, v);
    const float a = std::abs(2 * u - 1), b = std::abs(2 * v - 1);
    const float radius = a > b ? a : b;
    return {disc.x, disc.y, std::sqrt((1 - radius) * (1 + radius))};
}

/// A direction about +z with density 1/(2 pi), equal areas to equal areas: unit, z > 0 (Lambert's azimuthal
/// projection of the disc).
inline glm::vec3 uniform_hemisphere(float u, float v) {
    const glm::vec2 disc = concentric_disc(u, v);
    const float a = std::abs(2 * u - 1), b = std::abs(2 * v - 1);
    const float radius = a > b ? a : b;
    const float stretch = std::sqrt((1 - radius) * (1 + radius) + 1);
    return {disc.x * stretch, disc.y * stretch, (1 - radius) * (1 + radius)};
}

/// A right-handed orthonormal frame whose third column is the unit vector n (Duff et al., Building an
/// Orthonormal Basis, Revisited, 2017).
inline glm::dmat3 frame_about(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {glm::dvec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            glm::dvec3(b, sign + n.y * n.y * a, -n.y), n};
}

}  // namespace aoscore
