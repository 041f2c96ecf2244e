#pragma once

#include <span>
#include <string>

namespace aoscore {

/// What the page calls the causes of occlusion that the results name.
struct CauseText {
    const char* id;
    const char* label;
    const char* meaning;
};

/// In the order of the page's bars.
std::span<const CauseText> causes();

/// "" for an id that is none.
const char* cause_label(const std::string& id);

}  // namespace aoscore
