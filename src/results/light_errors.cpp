#include "results/light_errors.h"

namespace aoscore {

std::optional<LightError> least_light_error(const std::map<std::string, MeasureRecord>& light) {
    std::optional<LightError> least;
    for (const LightMode& mode : light_modes()) {
        const auto found = light.find(mode.relative_error());
        if (found != light.end() && (!least || found->second.value < least->error->value))
            least = LightError{&found->second, &mode};
    }
    return least;
}

}  // namespace aoscore
