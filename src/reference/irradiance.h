#pragma once

#include "core/environment.h"
#include "core/image.h"
#include "scene/camera.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>

namespace aoscore {

/// Ray-traced irradiance of every pixel's surface over pi, linear red, green and blue: 1 on an open surface
/// where all radiance is 1; 0 without surface. Two independent estimates, each from half of the rays, so that
/// an error can be told without their noise: their product with it has the right mean.
struct Irradiance {
    std::array<Image<glm::vec3>, 2> halves;
    int samples = 0;  ///< rays a pixel in all directions, and as many to the peaks of the environment if any

    glm::dvec3 mean(std::size_t i) const {
        return (glm::dvec3(halves[0].pixels[i]) + glm::dvec3(halves[1].pixels[i])) / 2.0;
    }
};

/// The root of the mean over the pixels that count of the variance of Irradiance::mean()'s luminance, as the
/// halves tell it; 0 where none counts.
double standard_error(const Irradiance& irradiance, const Mask& counted);
/// The mean luminance of Irradiance::mean() over the pixels that count; 0 where none does.
double mean_luminance(const Irradiance& irradiance, const Mask& counted);

/// When an irradiance has rays enough: its standard error is `relative_error` of its mean, or each pixel has
/// `most` rays.
struct IrradianceGoal {
    double relative_error = 0.01;
    int first = 64, most = 1024;  ///< even; steps double
};

/// Traces it under an environment that whatever lies within `radius_m` of a surface hides. What is much
/// brighter than the rest is found by rays that are sent there. The same picture for any thread count. Throws
/// usage_error for fewer than two `samples` a pixel or an odd number, interrupted_error on Ctrl-C.
Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Environment& environment,
                            double radius_m, int samples, std::uint64_t seed);
/// The same, with as many rays as the goal asks for.
Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Environment& environment,
                            double radius_m, const IrradianceGoal& goal, std::uint64_t seed);

}  // namespace aoscore
