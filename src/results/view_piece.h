#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace aoscore {

/// A part of a picture, pixels.
struct PictureBox {
    int left = 0, top = 0, width = 0, height = 0;
};

/// The view as a view file has it among its "views" (see scenes/README.md), with its members in that order.
nlohmann::ordered_json view_piece(const ViewRecord& view);

/// A view under the name `id` whose picture shows this part of the view's, as large as its own shape allows
/// and no more than that: from the same place, turned to the part's middle (orthographic: moved there).
nlohmann::ordered_json crop_piece(const ViewRecord& view, const PictureBox& box, const std::string& id);

}  // namespace aoscore
