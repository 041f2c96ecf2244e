#include "page/section.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

nlohmann::json section::live(const PageSource& source) {
    using nlohmann::json;
    const LiveData& live = source.live;
    std::size_t bytes = 0, layer_bytes = 0;
    for (const auto& [name, text] : live.blocks)
        (live.surface_blocks.contains(name) ? layer_bytes : bytes) += text.size();
    const auto mib_of_a_view = [&](std::size_t all) {
        const std::size_t views = std::max<std::size_t>(source.results.views.size(), 1);
        return fmt::format("{:.1f}", static_cast<double>(all) / static_cast<double>(views) / (1 << 20));
    };
    json refused = json::array();
    for (const LiveRefusal& method : live.refused)
        refused.push_back({{"label", method.label}, {"reason", method.reason}});
    const std::string in_short = live.missing.empty()
                                     ? "Sliders change a method’s parameters, and its picture and error "
                                       "follow, in this browser."
                                     : live.missing;
    return {{"in_short", in_short},          {"available", live.missing.empty()},
            {"missing", live.missing},       {"size", mib_of_a_view(bytes)},
            {"has_layers", layer_bytes > 0}, {"layers_size", mib_of_a_view(layer_bytes)},
            {"cautions", live.cautions},     {"has_refused", !refused.empty()},
            {"refused", std::move(refused)}};
}

}  // namespace aoscore
