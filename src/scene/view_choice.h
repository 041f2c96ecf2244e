#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Chooses among a scene's views. A choice is a view's id; "file", "nodes" or "auto" for all views of that
/// kind; "all" for every view; or empty for the views of the first kind, so that cameras of different origin
/// are averaged only where somebody asks for it. An id goes before a word. `views` are in the order of their
/// kinds. Throws usage_error where there is none, listing what there is.
std::vector<View> choose_views(std::string_view scene_id, const std::vector<View>& views,
                               std::string_view choice);

/// Says which views are left out where nobody names one, and how to ask for them: "sponza_crytek: taking 4
/// views of scenes/sponza_crytek/views.json, not its 4 camera nodes (--view nodes for these, --view all for
/// all)". Empty where no view is left out.
std::string left_out_text(const Scene& scene);

}  // namespace aoscore
