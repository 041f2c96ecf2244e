#pragma once

#include "reference/truth.h"
#include "screen/screen.h"

#include <filesystem>
#include <map>
#include <string>

namespace aoscore {

/// A truth as EXR: `Y` and `V0.Y`, `V1.Y`, … the visibility of each query (Y is the first), `SE.Y` and
/// `SE0.Y`, … the standard errors, `mask.Y` 1 where `valid` says so; radii, falloffs, samples and
/// `attributes` in the header.
void write_truth(const std::filesystem::path& path, const Truth& truth, const Mask& valid,
                 std::map<std::string, std::string> attributes);

/// A G-buffer as EXR: `Z` view depth in metres, `depth.Z` window depth, `N.X/Y/Z` geometric and `Ns.X/Y/Z`
/// smooth view-space normals, `albedo.R/G/B`, `mask.Y`, and `Y` equal to Z for viewers. What was not drawn is
/// left out.
void write_gbuffer(const std::filesystem::path& path, const GBufferImages& gbuffer,
                   const std::map<std::string, std::string>& attributes);

}  // namespace aoscore
