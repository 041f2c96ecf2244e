#pragma once

#include "plan/resolved_cell.h"
#include "scene/camera.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace aoscore {

/// All channels of the G-buffer that some method or filter of the registry reads.
std::set<std::string> gbuffer_inputs_of(const Registry& registry);

/// The data of a view that the page needs to draw methods on it.
struct LiveView {
    CameraFrame frame;
    std::optional<double> drawn_for_m;  ///< AO radius that lengths follow; empty: descriptors' own lengths
    bool keeps_surfaces = false;        ///< whether its G-buffer's file has the surfaces behind one another
};

/// Writes kLiveFile (results/live_file.h) into the folder: every method and filter of the registry, whose
/// user's own methods come from `methods_dir` (empty: none), and the views by their keys: their cameras, and
/// the lengths of every preset as it is drawn there.
void write_live_file(const std::filesystem::path& folder, const Registry& registry,
                     const std::filesystem::path& methods_dir, const std::map<std::string, LiveView>& views,
                     std::uint64_t seed);

}  // namespace aoscore
