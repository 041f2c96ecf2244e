#pragma once

#include "reference/tracer/hit_observer.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"

#include <string>

namespace aoscore {

/// What it is likely to take until every pixel has the standard error TruthSettings::max_error.
struct ErrorForecast {
    double rays_a_pixel = 0;  ///< the mean over all surfaces
    double most_rays = 0;     ///< one pixel in a hundred takes more
    double seconds = 0;       ///< with the threads of this process
    double power = 0;         ///< of a pixel's rays, by which its error falls
};

/// From a few tiles of the picture, each pixel of which gets a few rays, by how its error has fallen so far:
/// rough, a factor of two or so.
ErrorForecast forecast_error(const ReachableScene& scene, const CameraFrame& frame,
                             const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                             const CauseJudge& judge);

/// Throws usage_error, with the least error that is in reach, where this takes more than a day, or more rays
/// than kMostSamples for one pixel in a hundred or more.
void require_in_reach(const ErrorForecast& forecast, double max_error);

/// How a forecast is said before it is done: "an error of 0.001 in every pixel takes roughly …".
std::string forecast_text(const ErrorForecast& forecast, double max_error);

}  // namespace aoscore
