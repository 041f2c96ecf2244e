#pragma once

#include "image/image_file.h"
#include "page/live/live_layers.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// The data for running methods in the page: the shaders and cameras that the run left (results/live_file.h),
/// and the stored G-buffers.
struct LiveData {
    std::string missing;  ///< a sentence that says why nothing can be run; else empty

    /// {contract, methods, filters, views}: the run's file without the methods that cannot be run. Each view
    /// has, beside its camera, `inputs`: {name: {kind as PackedInput has it, data: name of the block}};
    /// `preview_inputs`, the same of every `preview_factor`-th pixel (live_preview.h); scene, view, radius_m,
    /// samples, noise_floor_rmse; and `cells`, the measured cells with method, preset, filter, parameters and
    /// the ranked metrics. Where surfaces behind one another were kept, `surfaces` and `preview_surfaces` are
    /// those of live_surfaces.h.
    nlohmann::json index;

    /// Methods, presets and measured cells that cannot be run in a browser.
    std::vector<LiveRefusal> refused;
    std::vector<std::string> cautions;  ///< sentences on views that live pictures are not exact in

    /// The texts of script elements by name: packed G-buffer inputs (live_packing.h).
    std::vector<std::pair<std::string, std::string>> blocks;
    std::set<std::string> surface_blocks;  ///< names of those that only methods over depth layers need
};

/// Reads the index, without the G-buffers' blocks. Throws file_error for a live.json that is damaged or lacks
/// a view.
LiveData read_live_data(const Results& results, const std::filesystem::path& folder);

/// Adds the blocks of a view's G-buffer, from the file at `path`, where nothing is missing. Returns the name
/// of the block that holds depth; empty where there is none. Throws file_error where it lacks a channel.
std::string add_gbuffer(LiveData& data, const ViewRecord& view, const ImageFile& gbuffer,
                        const std::filesystem::path& path);

/// The script elements that hold the data: "live index" and the blocks.
std::string live_blocks(const LiveData& data);

}  // namespace aoscore
