#pragma once

#include "experiment/resolved_cell.h"
#include "scene/camera.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace aoscore {

/// Everything of the G-buffer that some method or filter of the registry reads.
std::set<std::string> gbuffer_inputs_of(const Registry& registry);

/// Writes kLiveFile (results/live_file.h) into the folder: every method and filter of the registry, whose
/// user's own methods come from `methods_dir` (empty: none), and the views' cameras by their keys.
void write_live_file(const std::filesystem::path& folder, const Registry& registry,
                     const std::filesystem::path& methods_dir,
                     const std::map<std::string, CameraFrame>& views, std::uint64_t seed);

}  // namespace aoscore
