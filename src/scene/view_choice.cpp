#include "scene/view_choice.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {
namespace {

constexpr std::array<std::pair<std::string_view, View::Kind>, 3> kKindWords{
    {{"file", View::Kind::filed}, {"nodes", View::Kind::node}, {"auto", View::Kind::automatic}}};

std::vector<View> of_kind(const Scene& scene, View::Kind kind) {
    std::vector<View> views;
    std::ranges::copy_if(scene.views, std::back_inserter(views),
                         [&](const View& view) { return view.kind == kind; });
    return views;
}

}  // namespace

std::vector<View> choose_views(const Scene& scene, std::string_view choice) {
    if (choice.empty()) return of_kind(scene, scene.views.front().kind);
    const bool is_id =
        std::ranges::any_of(scene.views, [&](const View& view) { return view.id == choice; });
    if (!is_id && choice == "all") return scene.views;
    for (const auto& [word, kind] : kKindWords) {
        if (is_id || word != choice) continue;
        std::vector<View> views = of_kind(scene, kind);
        if (!views.empty()) return views;
    }
    return {find_view(scene, choice)};
}

std::string left_out_text(const Scene& scene) {
    const std::size_t nodes = of_kind(scene, View::Kind::node).size();
    const std::vector<View> taken = choose_views(scene, "");
    if (taken.front().kind != View::Kind::filed || nodes == 0) return "";
    return fmt::format("{}: taking {} {} of {}, not its {} camera {} (--view nodes for {}, --view all for all)",
                       scene.id, taken.size(), taken.size() == 1 ? "view" : "views", taken.front().source, nodes,
                       nodes == 1 ? "node" : "nodes", nodes == 1 ? "it" : "these");
}

}  // namespace aoscore
