#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Those of a scene's views that a choice stands for: a view's id; "file", "nodes" or "auto", all views of
/// that kind; "all", every one; or nothing, the views of the first kind, so that cameras of different origin
/// are averaged only where somebody asks for it. An id goes before a word. `views` are in the order of their
/// kinds. Throws usage_error where there is none, listing what there is.
std::vector<View> choose_views(std::string_view scene_id, const std::vector<View>& views,
                               std::string_view choice);

/// Which views are left out where nobody names one, and how to ask for them: "sponza_crytek: taking 4 views
/// of scenes/sponza_crytek/views.json, not its 4 camera nodes (--view nodes for these, --view all for all)".
/// Empty where none is.
std::string left_out_text(const Scene& scene);

}  // namespace aoscore
