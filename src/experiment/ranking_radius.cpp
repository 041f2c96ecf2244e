#include "experiment/ranking_radius.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

constexpr double kAutomaticShare = 0.02;

}  // namespace

RankingRadius ranking_radius(const std::optional<double>& asked_m, const View& view, const Scene& scene) {
    if (asked_m) return {*asked_m, false, "named by the command or report"};
    if (view.radius_m) return {*view.radius_m, false, "named by the view"};
    return {kAutomaticShare * scene.bounds.diagonal(), true,
            fmt::format("{:g} % of the scene's diagonal", 100 * kAutomaticShare)};
}

std::string radius_warning(const RankingRadius& radius, const View& view) {
    if (!radius.automatic) return {};
    return fmt::format("no radius is named for view {}; ranked, and methods drawn, at {:.4g} m, {}", view.id,
                       radius.metres, radius.rule);
}

}  // namespace aoscore
