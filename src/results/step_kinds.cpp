#include "results/step_kinds.h"

#include "core/known_names.h"

#include <array>

namespace aoscore {

std::span<const StepKind> step_kinds() {
    static constexpr std::array<StepKind, 10> kKinds{{
        {"more-taps", "more taps", "Twice as many of one of the counts that make the method's taps."},
        {"full-resolution", "full resolution", "Every pixel is shaded."},
        {"exact-normals", "exact normals", "Normals of the triangles in place of those that it reads."},
        {"guard-band", "a guard band",
         "A tenth of the picture's size is drawn and shaded on every side, and cut off."},
        {"second-layer", "a second depth layer",
         "The same method over the first depth layer and the next one behind it."},
        {"larger-radius", "a larger radius",
         "The method's lengths are half as long again; the truth keeps its radius."},
        {"tuned-preset", "the tuned preset", "The preset that a tuning over other views has found."},
        {"best-strength", "the best strength",
         "The curve of strength and exponent that brings this very picture nearest to the truth, to which it "
         "was fitted: a multiplication and a power a pixel, which are not timed."},
        {"no-noise", "noise averaged away",
         "The mean over all seeds, which frames that are accumulated approach: the squared error less the "
         "variance over four seeds. Accumulating itself is not timed."},
        {"no-filter", "the filter taken off", "The picture before its filter."},
    }};
    return kKinds;
}

std::string step_label(std::string_view id) {
    const std::span<const StepKind> kinds = step_kinds();
    const StepKind* kind = find_row(kinds, id);
    return std::string(kind == nullptr ? id : kind->label);
}

}  // namespace aoscore
