#include "page/sections/causes.h"

#include "core/known_names.h"

#include <algorithm>
#include <array>

namespace aoscore {

std::span<const CauseText> causes() {
    static constexpr std::array<CauseText, 4> kCauses = {{
        {"outside", "outside the frame", "the occluder lies outside what the camera sees"},
        {"hidden", "hidden", "the occluder lies behind what the camera sees"},
        {"grazing", "grazing", "the occluder turns away from the camera, or is seen at a grazing angle"},
        {"visible", "visible", "the occluder is in the G-buffer: the method's own loss"},
    }};
    return kCauses;
}

const char* cause_label(const std::string& id) {
    const std::span<const CauseText> table = causes();
    const CauseText* found = find_row(table, id);
    return found == nullptr ? "" : found->label;
}

}  // namespace aoscore
