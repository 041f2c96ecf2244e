#pragma once

#include "core/environment.h"
#include "core/environment_cones.h"
#include "reference/irradiance.h"
#include "reference/truth.h"
#include "results/light_modes.h"
#include "results/results.h"
#include "scene/camera.h"
#include "screen/screen.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>

// This is a file of its own, because its code is a part of the keys of what it makes (aoscore_code_digests()
// in CMakeLists.txt).
namespace aoscore {

/// Whether the image has the signals that the mode takes.
bool applies(const LightMode& mode, const MethodOutput& image);

/// What a picture is lit by.
struct EnvironmentLight {
    const EnvironmentCones& cones;
    const CameraFrame& frame;
    const Image<glm::vec3>& normals;  ///< view space, unit
};

/// Irradiance over pi of every `valid` pixel, linear red, green and blue. Throws internal_error where the
/// mode does not apply to the image.
Image<glm::vec3> lit_image(const LightMode& mode, const EnvironmentLight& light, const MethodOutput& image,
                           const Mask& valid);

/// Errors with their intervals, by the ids of LightMode.
using LightErrors = std::map<std::string, MeasureRecord>;

/// The errors of the irradiance's luminance by every mode that applies, with intervals by resampled blocks of
/// the picture: "rmse.MODE", the root mean squared error; "relative_rmse.MODE", the same over the mean of the
/// traced irradiance; "bias.MODE", the mean error over that mean; "gain.MODE", what it takes off the rmse of
/// the mode before. The noise of the rays is not in them. Empty where no pixel is valid.
LightErrors light_errors(const EnvironmentLight& light, const MethodOutput& image, const Irradiance& truth,
                         const Mask& valid, std::uint64_t seed);

/// The record of a traced irradiance, with the errors of lighting by the visibility, the bent normal and the
/// cone of `truth`, as far as it has them.
LightRecord light_record(const EnvironmentLight& light, const Environment& environment, const Truth& truth,
                         const Irradiance& irradiance, const Mask& valid, std::uint64_t seed);

nlohmann::json to_json(const LightRecord& record);
LightRecord light_record_from_json(const nlohmann::json& json, const std::string& where);
nlohmann::json to_json(const LightErrors& errors);
LightErrors light_errors_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
