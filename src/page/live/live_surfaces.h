#pragma once

#include "image/image_file.h"
#include "page/live/live_packing.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace aoscore {

/// The surfaces behind one another of a view, packed for the page.
struct PackedSurfaces {
    /// {depths, triangles: a block's name for each layer (surface_packing.h), numbers: the block of the
    /// triangles' numbers, count: how many numbers, first_is_depth: whether the first of the depths is the
    /// G-buffer's depth, as pack_floats() has it}. Depths are positive. A triangle is twice its place among
    /// the numbers, and 1 more where it is seen from behind.
    nlohmann::json index, preview_index;
    /// The share of pixels that may have surfaces behind the last one kept, since as many are kept as can be.
    double full_share = 0;
};

/// Packs the surfaces of a G-buffer's file, whose path is `path` and whose background has the depth `far_m`;
/// `add_block` gets each block's name, which begins with `name`, and its text. The first surface is mostly
/// the G-buffer's own depth, which lies in `depth_block` (empty: nowhere) and is not packed again. Previews
/// have every `factor`-th pixel (live_preview.h), and names that end in " preview". Throws file_error for a
/// layer without all of its channels.
PackedSurfaces pack_surfaces(const ImageFile& gbuffer, const std::filesystem::path& path, double far_m,
                             const std::string& name, const std::string& depth_block, int factor,
                             const std::function<void(std::string, std::string)>& add_block);

}  // namespace aoscore
