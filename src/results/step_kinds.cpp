#include "results/step_kinds.h"

#include "core/known_names.h"

#include <array>

namespace aoscore {

std::span<const StepKind> step_kinds() {
    static constexpr std::array<StepKind, 10> kKinds{{
        {"more-taps", "more taps", "One of the counts that make up the method's taps is doubled."},
        {"full-resolution", "full resolution", "Every pixel is shaded."},
        {"exact-normals", "exact normals", "It reads the triangles' own normals."},
        {"guard-band", "a guard band",
         "A tenth of the picture's size is drawn and shaded on every side, and cut off."},
        {"second-layer", "a second depth layer",
         "It reads the first depth layer and the next one behind it."},
        {"larger-radius", "a larger radius",
         "The method's lengths are half as long again; the truth keeps its radius."},
        {"tuned-preset", "the tuned preset",
         "It runs with the preset that a tuning over other views has found."},
        {"best-strength", "the best strength",
         "Strength and exponent are fitted to the truth of this very picture. They cost a multiplication and "
         "a "
         "power a pixel, which are not timed."},
        {"no-noise", "noise averaged away",
         "Noise is taken off, as accumulated frames would: the squared error minus its variance over four "
         "seeds. Accumulating is not timed."},
        {"no-filter", "the filter taken off", "The picture is scored before its filter."},
    }};
    return kKinds;
}

std::string step_label(std::string_view id) {
    const std::span<const StepKind> kinds = step_kinds();
    const StepKind* kind = find_row(kinds, id);
    return std::string(kind == nullptr ? id : kind->label);
}

}  // namespace aoscore
