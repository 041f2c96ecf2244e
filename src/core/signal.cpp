#include "core/signal.h"

#include "core/known_names.h"

#include <array>
#include <numbers>

namespace aoscore {
namespace {

constexpr std::array<std::string_view, 1> kVisibilityChannels{"Y"};
constexpr std::array<std::string_view, 3> kBentNormalChannels{"bent.X", "bent.Y", "bent.Z"};
constexpr std::array<std::string_view, 1> kConeAngleChannels{"cone.Y"};

constexpr std::array<Signal, 3> kSignals{{
    {.id = kVisibilitySignal,
     .label = "Visibility",
     .meaning = "The open part of the hemisphere, weighted by the cosine: 1 where all is open.",
     .unit = "",
     .channels = kVisibilityChannels,
     .error_channel = "SE.Y"},
    {.id = "bent_normal",
     .label = "Bent normal",
     .meaning = "The mean of the open directions, in view space. Its direction is compared, not its length.",
     .unit = "",
     .low = -1,
     .channels = kBentNormalChannels,
     .error_channel = "SE.bent.Y"},
    {.id = "cone_angle",
     .label = "Cone angle",
     .meaning = "The half angle of the cone about the bent normal that is open: π/2 where all is.",
     .unit = "rad",
     .high = std::numbers::pi / 2,
     .channels = kConeAngleChannels,
     .error_channel = "SE.cone.Y"},
}};

}  // namespace

std::span<const Signal> signals() {
    return kSignals;
}

const Signal& signal(std::string_view id) {
    return row_of(kSignals, id, "no signal");
}

std::vector<std::string> further_signals() {
    std::vector<std::string> ids = ids_of(kSignals);
    std::erase(ids, kVisibilitySignal);
    return ids;
}

}  // namespace aoscore
