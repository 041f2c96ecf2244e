#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// An export of pictures to learn from.
struct TrainingPlan {
    std::vector<std::string> scenes;  ///< built-in ids or paths
    LoadOptions load;
    std::size_t views = 16;  ///< cameras of each scene
    std::optional<double> height_m;
    std::optional<double> radius_m;
    int width = 640, height = 360;
    int samples = 256;  ///< rays a pixel of the truth
    std::uint64_t seed = 1;
    std::filesystem::path truth_cache;
    std::string command;
};

/// The split of each scene: "train", "validation" or "test". All pictures of a scene are in one, so that
/// nothing that was learnt of it is asked again. Scenes are put in order by their digests, which hold no
/// name: of n scenes the first n/6 (rounded) are for the test, the next as many for validation; with two
/// scenes one is for the test. Copies of a scene share a split. One scene alone is all for training.
std::vector<std::string> splits_of(const std::vector<std::string>& digests);

/// Writes for each view, below a folder of its scene, VIEW.gbuffer.exr with all channels and VIEW.truth.exr
/// with standard errors and causes; and manifest.json, which names them with their views, as in a
/// view file, radii and splits. Views
/// are spread over the scene (spread_cameras()), those worth most first, and no neighbours. Returns the
/// manifest's path. Throws gate_failed for a scene without a camera that can be judged.
std::filesystem::path export_training(const TrainingPlan& plan, const std::filesystem::path& folder);

}  // namespace aoscore
