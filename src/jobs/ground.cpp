#include "jobs/ground.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace aoscore {

Ground find_ground(const CameraFrame& frame, const Truth& truth, const GBufferImages& gbuffer,
                   const Bounds& scene_bounds) {
    const double extent = glm::max(glm::length(scene_bounds.low), glm::length(scene_bounds.high));
    return {check_camera_contract(frame, truth.hits, gbuffer, extent), pixel_facts(frame, truth)};
}

void require_comparable(const Ground& ground) {
    const CameraContract& contract = ground.contract;
    if (!contract.kept()) {
        throw internal_error(
            fmt::format("ray tracer and rasteriser disagree on {:.2f} % of the pixels away from "
                        "edges, more than {:.1f} %",
                        100 * contract.disagreeing_share(), 100 * CameraContract::kTolerated));
    }
    if (contract.valid_count == 0)
        throw Error(ExitCode::gate_failed, emptiness(contract.surface, contract.valid_count));
}

void record_ground(const Ground& ground, const CameraFrame& frame, const Truth& truth, double radius_m,
                   ViewRecord& view) {
    const CameraContract& contract = ground.contract;
    view.surface_pixels = contract.surface;
    view.valid_pixels = contract.valid_count;
    view.disagreeing_pixels = contract.disagreeing;
    view.edge_pixels = contract.edges;
    std::vector<float> depths;
    for (std::size_t i = 0; i < truth.hits.depth.size(); ++i) {
        if (contract.valid.pixels[i] != 0) depths.push_back(truth.hits.depth.pixels[i]);
    }
    if (depths.empty()) return;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    view.radius_px_median = radius_m * frame.pixels_per_metre(static_cast<double>(*middle));
}

}  // namespace aoscore
