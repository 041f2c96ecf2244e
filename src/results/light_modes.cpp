#include "results/light_modes.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

constexpr std::array kLightModes{
    LightMode{
        .id = "normal",
        .label = "normal",
        .meaning = "Visibility times the irradiance of an open surface with the normal of the surface."},
    LightMode{.id = "bent_normal",
              .label = "bent normal",
              .meaning = "Visibility times the irradiance of an open surface with the bent normal.",
              .bent = true},
    LightMode{.id = "cone",
              .label = "bent cone",
              .meaning =
                  "Visibility times the mean radiance within the cone about the bent normal, weighted by the "
                  "cosine to it.",
              .bent = true,
              .cone = true},
    LightMode{
        .id = "cone_alone",
        .label = "cone alone",
        .meaning = "The same with the cone’s own open part, the square of its sine, in place of visibility.",
        .bent = true,
        .cone = true,
        .alone = true},
};

}  // namespace

std::array<std::string, 3> LightMode::channels() const {
    return {fmt::format("{}.R", id), fmt::format("{}.G", id), fmt::format("{}.B", id)};
}

std::string LightMode::error() const {
    return fmt::format("rmse.{}", id);
}
std::string LightMode::relative_error() const {
    return fmt::format("relative_rmse.{}", id);
}
std::string LightMode::bias() const {
    return fmt::format("bias.{}", id);
}
std::string LightMode::gain() const {
    return fmt::format("gain.{}", id);
}

std::vector<std::string> LightMode::measures() const {
    std::vector<std::string> ids{error(), relative_error(), bias()};
    if (id != kLightModes.front().id) ids.push_back(gain());
    return ids;
}

std::span<const LightMode> light_modes() {
    return kLightModes;
}

}  // namespace aoscore
