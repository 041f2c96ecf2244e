#pragma once

#include "core/sky.h"
#include "reference/irradiance.h"
#include "results/results.h"
#include "scene/camera.h"
#include "screen/screen.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

// This is a file of its own, because its code is a part of the code of scores (aoscore_code_digests() in
// CMakeLists.txt).
namespace aoscore {

/// A way to light a surface by what a method knows: visibility, bent normal and cone (Vermeer,
/// Stochastic-Depth Ambient Occlusion, 2020, section 7.1; whether a cone's light is a mean over the cone, and
/// whether visibility multiplies it, is not said there).
struct LightMode {
    std::string_view id;
    std::string_view meaning;  ///< follows "Irradiance"
    bool bent = false;         ///< about the bent normal instead of the surface's
    bool cone = false;         ///< the mean over the cone instead of the hemisphere
    bool alone = false;        ///< the cone's own solid angle in place of visibility
};
/// The one table of them, the plainest first.
std::span<const LightMode> light_modes();

/// What a picture is lit by.
struct SkyLight {
    const SkyCones& cones;
    const CameraFrame& frame;
    const Image<glm::vec3>& normals;  ///< view space, unit
};

/// Irradiance over pi of every `valid` pixel. `image` holds bent normals and cones. Throws internal_error
/// where it does not.
ImageF lit_image(const LightMode& mode, const SkyLight& light, const MethodOutput& image, const Mask& valid);

/// The root mean squared errors "rmse.MODE" of every mode and what they gain on the mode before,
/// "gain.MODE", with their intervals: by resampled blocks of the picture. The noise of the rays is not in
/// them.
std::map<std::string, MeasureRecord> light_errors(const SkyLight& light, const MethodOutput& image,
                                                  const Irradiance& truth, const Mask& valid,
                                                  std::uint64_t seed);

}  // namespace aoscore
