#include "scene/view_choice.h"

#include "core/counted.h"
#include "core/known_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {
namespace {

constexpr std::array<std::pair<std::string_view, View::Kind>, 3> kKindWords{
    {{"file", View::Kind::filed}, {"nodes", View::Kind::node}, {"auto", View::Kind::automatic}}};

std::vector<View> of_kind(const std::vector<View>& views, View::Kind kind) {
    std::vector<View> chosen;
    std::ranges::copy_if(views, std::back_inserter(chosen),
                         [&](const View& view) { return view.kind == kind; });
    return chosen;
}

const View& named(std::string_view scene_id, const std::vector<View>& views, std::string_view id) {
    return row_of(views, id, fmt::format("scene {} has no view", scene_id), "--view");
}

}  // namespace

const View& find_view(const Scene& scene, std::string_view id) {
    return named(scene.id, scene.views, id);
}

std::vector<View> choose_views(std::string_view scene_id, const std::vector<View>& views,
                               std::string_view choice) {
    if (choice.empty() && !views.empty()) return of_kind(views, views.front().kind);
    const bool is_id = std::ranges::any_of(views, [&](const View& view) { return view.id == choice; });
    if (!is_id && choice == "all" && !views.empty()) return views;
    for (const auto& [word, kind] : kKindWords) {
        if (is_id || word != choice) continue;
        std::vector<View> chosen = of_kind(views, kind);
        if (!chosen.empty()) return chosen;
    }
    return {named(scene_id, views, choice)};
}

std::string left_out_text(const Scene& scene) {
    const std::size_t nodes = of_kind(scene.views, View::Kind::node).size();
    if (scene.views.empty()) return "";
    const std::vector<View> taken = choose_views(scene.id, scene.views, "");
    if (taken.front().kind != View::Kind::filed || nodes == 0) return "";
    return fmt::format("{}: taking {} of {}, not its {} (--view nodes for {}, --view all for all)", scene.id,
                       counted(taken.size(), "view", "views"), taken.front().source,
                       counted(nodes, "camera node", "camera nodes"), nodes == 1 ? "it" : "these");
}

}  // namespace aoscore
