#pragma once

#include <span>
#include <string>

namespace aoscore {

/// The page's names for the causes of occlusion in the results.
struct CauseText {
    const char* id;
    const char* label;
    const char* meaning;
};

/// All causes in the order of the page's bars.
std::span<const CauseText> causes();

/// The label of a cause; "" for an unknown id.
const char* cause_label(const std::string& id);

}  // namespace aoscore
