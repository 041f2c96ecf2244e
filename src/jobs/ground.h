#pragma once

#include "jobs/camera_contract.h"
#include "jobs/pixel_facts.h"
#include "results/results.h"

namespace aoscore {

/// The pixels over which every image of a view is compared, since both paths agree on them, with facts about
/// each.
struct Ground {
    CameraContract contract;
    PixelFacts facts;  ///< refers to the truth that it was made of
};

/// Compares the truth's primary hits with the G-buffer's surfaces.
Ground find_ground(const CameraFrame& frame, const Truth& truth, const GBufferImages& gbuffer,
                   const Bounds& scene_bounds);

/// Throws internal_error where ray tracer and rasteriser disagree, and gate_failed where no pixel can be
/// compared.
void require_comparable(const Ground& ground);

/// Records the ground in the results, and the AO radius in pixels at its median depth.
void record_ground(const Ground& ground, const CameraFrame& frame, const Truth& truth, double radius_m,
                   ViewRecord& view);

}  // namespace aoscore
