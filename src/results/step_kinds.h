#pragma once

#include <span>
#include <string>
#include <string_view>

namespace aoscore {

/// A kind of step that advice measures, as it is named everywhere.
struct StepKind {
    std::string_view id;       ///< StepRecord::id
    std::string_view label;    ///< "more taps"
    std::string_view meaning;  ///< a sentence
};
/// All kinds, in the order of lists.
std::span<const StepKind> step_kinds();

/// The label of a kind; the id itself for an unknown one.
std::string step_label(std::string_view id);

}  // namespace aoscore
