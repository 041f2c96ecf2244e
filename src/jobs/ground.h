#pragma once

#include "jobs/camera_contract.h"
#include "jobs/pixel_facts.h"
#include "results/results.h"

namespace aoscore {

/// What both paths agree on, and what is known of each pixel: what every image of a view is compared over.
struct Ground {
    CameraContract contract;
    PixelFacts facts;  ///< points into the truth it was made of
};

/// Holds the truth's primary hits against the G-buffer's surfaces.
Ground find_ground(const CameraFrame& frame, const Truth& truth, const GBufferImages& gbuffer,
                   const Bounds& scene_bounds);

/// Fills in what the results say of the ground, and of the AO radius in pixels at its median depth.
void record_ground(const Ground& ground, const CameraFrame& frame, const Truth& truth, double radius_m,
                   ViewRecord& view);

}  // namespace aoscore
