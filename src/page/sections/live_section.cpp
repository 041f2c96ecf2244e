#include "page/section.h"

#include <fmt/format.h>

namespace aoscore {

nlohmann::json section::live(const PageSource& source) {
    using nlohmann::json;
    const LiveData& live = source.live;
    std::size_t bytes = 0;
    for (const auto& [name, text] : live.blocks) bytes += text.size();
    json refused = json::array();
    for (const LiveRefusal& method : live.refused)
        refused.push_back({{"label", method.label}, {"reason", method.reason}});
    const std::string in_short = live.missing.empty()
                                     ? "Sliders change a method’s parameters, and its picture and error "
                                       "follow, in this browser."
                                     : live.missing;
    return {{"in_short", in_short},
            {"available", live.missing.empty()},
            {"missing", live.missing},
            {"size", fmt::format("{:.1f}", static_cast<double>(bytes) / (1 << 20))},
            {"cautions", live.cautions},
            {"has_refused", !refused.empty()},
            {"refused", std::move(refused)}};
}

}  // namespace aoscore
