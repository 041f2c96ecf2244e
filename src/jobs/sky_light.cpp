#include "jobs/sky_light.h"

#include "core/error.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/intervals/bootstrap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace aoscore {
namespace {

constexpr std::array kModes{
    LightMode{.id = "normal", .meaning = "by visibility and the surface's normal"},
    LightMode{.id = "bent_normal", .meaning = "by visibility and the bent normal", .bent = true},
    LightMode{.id = "cone", .meaning = "by visibility and the bent cone", .bent = true, .cone = true},
    LightMode{
        .id = "cone_alone", .meaning = "by the bent cone alone", .bent = true, .cone = true, .alone = true},
};

/// Sums over blocks of the picture of one mode's errors: of their product with both halves of the truth,
/// whose noise is not in it, since neither half knows of the other.
struct ModeSums {
    std::vector<double> products, counts;
};

ModeSums sums_of(const ImageF& lit, const Irradiance& truth, const Mask& valid) {
    const BlockGrid grid(valid.width, valid.height);
    ModeSums sums{std::vector<double>(grid.size(), 0), std::vector<double>(grid.size(), 0)};
    for (int y = 0; y < valid.height; ++y) {
        const std::size_t row = valid.index(0, y);
        grid.for_each_piece(y, 0, valid.width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) {
                const std::size_t i = row + static_cast<std::size_t>(x);
                if (valid.pixels[i] == 0) continue;
                const double value = double{lit.pixels[i]};
                sums.products[block] +=
                    (value - double{truth.halves[0].pixels[i]}) * (value - double{truth.halves[1].pixels[i]});
                sums.counts[block] += 1;
            }
        });
    }
    return sums;
}

/// The root mean squared error over blocks; `counted` says how often each counts.
double rmse(const ModeSums& sums, const std::vector<double>& counted) {
    double product = 0, count = 0;
    for (std::size_t b = 0; b < counted.size(); ++b) {
        product += counted[b] * sums.products[b];
        count += counted[b] * sums.counts[b];
    }
    return std::sqrt(std::max(product / count, 0.0));
}

const SignalImage& signal_of(const MethodOutput& image, const char* id) {
    const auto found = image.signals.find(id);
    if (found == image.signals.end()) throw internal_error("light needs the signal", id);
    return found->second;
}

glm::dvec3 vector_at(const SignalImage& planes, std::size_t i) {
    return {double{planes[0].pixels[i]}, double{planes[1].pixels[i]}, double{planes[2].pixels[i]}};
}

}  // namespace

std::span<const LightMode> light_modes() {
    return kModes;
}

ImageF lit_image(const LightMode& mode, const SkyLight& light, const MethodOutput& image, const Mask& valid) {
    const SignalImage& bent = signal_of(image, "bent_normal");
    const SignalImage& cone = signal_of(image, "cone_angle");
    const glm::dmat3 world_from_view(light.frame.world_from_view());
    ImageF lit(valid.width, valid.height, 0);
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid.pixels[i] == 0) continue;
        glm::dvec3 axis(light.normals.pixels[i]);
        const glm::dvec3 open = vector_at(bent, i);
        const double length = glm::length(open);
        if (mode.bent && length > 0) axis = open / length;
        const double half_angle = mode.cone ? double{cone[0].pixels[i]} : std::numbers::pi / 2;
        const double sine = std::sin(half_angle);
        const double open_part = mode.alone ? sine * sine : double{image.visibility.pixels[i]};
        const double radiance = light.cones.mean_radiance(world_from_view * axis, half_angle);
        lit.pixels[i] = static_cast<float>(open_part * radiance);
    }
    return lit;
}

std::map<std::string, MeasureRecord> light_errors(const SkyLight& light, const MethodOutput& image,
                                                  const Irradiance& truth, const Mask& valid,
                                                  std::uint64_t seed) {
    constexpr int kResamples = 2000;
    std::vector<ModeSums> sums;
    for (const LightMode& mode : kModes)
        sums.push_back(sums_of(lit_image(mode, light, image, valid), truth, valid));
    const std::size_t blocks = sums.front().counts.size();
    const std::vector<double> once(blocks, 1);
    std::vector<std::vector<double>> drawn(kModes.size());
    std::mt19937_64 random(seed);
    for (int i = 0; i < kResamples; ++i) {
        std::vector<double> counted(blocks, 0);
        for (std::size_t k = 0; k < blocks; ++k) counted[random() % blocks] += 1;
        for (std::size_t m = 0; m < kModes.size(); ++m) drawn[m].push_back(rmse(sums[m], counted));
    }
    std::map<std::string, MeasureRecord> errors;
    for (std::size_t m = 0; m < kModes.size(); ++m) {
        const std::string id(kModes[m].id);
        errors["rmse." + id] = {rmse(sums[m], once), confidence_interval(drawn[m])};
        if (m == 0) continue;
        errors["gain." + id] = {rmse(sums[m - 1], once) - rmse(sums[m], once),
                                confidence_interval(drawn[m - 1], drawn[m])};
    }
    return errors;
}

}  // namespace aoscore
