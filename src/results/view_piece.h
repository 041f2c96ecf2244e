#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace aoscore {

/// A part of a picture, in pixels.
struct PictureBox {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Writes the view as an entry of a view file's "views" (see scenes/README.md), with its members in that
/// order.
nlohmann::ordered_json view_piece(const ViewRecord& view);

/// Writes a view named `id` whose picture shows this part of the view's, as large as the shape of its own
/// picture allows. The camera stays in place and turns to the part's middle (orthographic: it moves there).
nlohmann::ordered_json crop_piece(const ViewRecord& view, const PictureBox& box, const std::string& id);

}  // namespace aoscore
