#include "page/sections/closest_sentence.h"

#include "page/sections/listing.h"

#include <fmt/format.h>

namespace aoscore {

std::string closest_sentence(const ClosestMethods& methods) {
    const std::string& first = methods.leaders.front();
    if (methods.ranked == 1) {
        return fmt::format("{} is the only method scored {}: its {} is {}.", first, methods.where,
                           methods.metric, methods.value);
    }
    if (methods.leaders.size() == 1) {
        return fmt::format("{} is closest of {} methods to the ray-traced truth {}: its {} is {}.", first,
                           methods.ranked, methods.where, methods.metric, methods.value);
    }
    return fmt::format(
        "{} tie as the closest of {} methods to the ray-traced truth {}: their {}s do not differ "
        "significantly.",
        listed(methods.leaders), methods.ranked, methods.where, methods.metric);
}

}  // namespace aoscore
