#include "screen/method/kernel.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace aoscore {
namespace {

// Mixes the bits of a counter by the finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable
// pseudorandom number generators", 2014).
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

std::uint64_t text_hash(const std::string& text) {
    std::uint64_t h = 0;
    for (const char c : text) h = mix(h ^ static_cast<unsigned char>(c));
    return h;
}

double unit_number(std::uint64_t h) {
    return static_cast<double>(h >> 11) * 0x1p-53;
}

// Gives each point three numbers in [0,1) for the direction, and a fourth for the radius.
class Numbers {
  public:
    Numbers(const Kernel& kernel, std::uint64_t seed)
        : stream_(mix(seed ^ text_hash(kernel.id))), low_discrepancy_(kernel.sequence == "low_discrepancy") {}

    std::array<double, 4> of(std::size_t i) const {
        std::array<double, 4> result{};
        for (std::size_t d = 0; d < 4; ++d) {
            result[d] = low_discrepancy_ ? recurrence(i, d) : unit_number(mix(mix(stream_ + d) + i));
        }
        return result;
    }

  private:
    // Powers of the inverse of the root of x^5 = x + 1: the four-dimensional recurrence (Roberts 2018).
    double recurrence(std::size_t i, std::size_t dimension) const {
        constexpr double kRoot = 1.1673039782614187;
        const double step = std::pow(1.0 / kRoot, static_cast<double>(dimension + 1));
        const double x = unit_number(mix(stream_ + dimension)) + static_cast<double>(i) * step;
        return x - std::floor(x);
    }
    std::uint64_t stream_;
    bool low_discrepancy_;
};

glm::dvec3 from_height(double z, double turn) {
    const double r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * std::numbers::pi * turn;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

glm::dvec3 direction(const std::string& kind, const std::array<double, 4>& u) {
    if (kind == "sphere_cube") {
        const glm::dvec3 p(2 * u[0] - 1, 2 * u[1] - 1, 2 * u[2] - 1);
        const double length = glm::length(p);
        return length > 0 ? p / length : glm::dvec3(0, 0, 1);
    }
    if (kind == "hemisphere_cube") {
        const glm::dvec3 p(2 * u[0] - 1, 2 * u[1] - 1, u[2]);
        const double length = glm::length(p);
        return length > 0 ? p / length : glm::dvec3(0, 0, 1);
    }
    if (kind == "hemisphere") return from_height(u[0], u[1]);
    if (kind == "hemisphere_cosine") return from_height(std::sqrt(1 - u[0]), u[1]);
    if (kind == "disc") return from_height(0, u[1]);
    return from_height(1 - 2 * u[0], u[1]);
}

double radius(const Kernel& kernel, double u) {
    if (kernel.radii == "uniform") return u;
    if (kernel.radii == "volume") return kernel.directions == "disc" ? std::sqrt(u) : std::cbrt(u);
    return 1;
}

double scale(const std::string& kind, std::size_t i, std::size_t size) {
    if (kind == "none") return 1;
    const double t = static_cast<double>(i) / (kind == "squared_of_64" ? 64.0 : static_cast<double>(size));
    return std::lerp(0.1, 1.0, t * t);
}

}  // namespace

const std::set<std::string>& KernelChoices::directions() {
    static const std::set<std::string> all = {"sphere",          "sphere_cube",       "hemisphere",
                                              "hemisphere_cube", "hemisphere_cosine", "disc"};
    return all;
}
const std::set<std::string>& KernelChoices::radii() {
    static const std::set<std::string> all = {"shell", "uniform", "volume"};
    return all;
}
const std::set<std::string>& KernelChoices::scales() {
    static const std::set<std::string> all = {"none", "squared", "squared_of_64"};
    return all;
}
const std::set<std::string>& KernelChoices::sequences() {
    static const std::set<std::string> all = {"random", "low_discrepancy"};
    return all;
}

std::vector<glm::vec3> generate_kernel(const Kernel& kernel, std::uint64_t seed) {
    const Numbers numbers(kernel, seed);
    const std::size_t size = std::stoul(kernel.size);
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < size; ++i) {
        const auto u = numbers.of(i);
        points.emplace_back(direction(kernel.directions, u) * radius(kernel, u[3]) *
                            scale(kernel.scale, i, size));
    }
    return points;
}

Image<glm::vec4> generate_noise_4x4(std::uint64_t seed) {
    constexpr int kTexels = 16;
    Image<glm::vec4> noise(4, 4);
    for (glm::length_t channel = 0; channel < 4; ++channel) {
        std::array<int, kTexels> order{};
        for (int i = 0; i < kTexels; ++i) order[static_cast<std::size_t>(i)] = i;
        std::uint64_t state = mix(seed + 0x4e015eU) + static_cast<std::uint64_t>(channel);
        for (std::size_t i = kTexels - 1; i > 0; --i) {
            state = mix(state);
            std::swap(order[i], order[state % (i + 1)]);
        }
        for (std::size_t i = 0; i < kTexels; ++i) {
            noise.pixels[i][channel] = (static_cast<float>(order[i]) + 0.5F) / kTexels;
        }
    }
    return noise;
}

}  // namespace aoscore
