#include "plan/ranking_radius.h"

#include "framing/automatic_views.h"
#include "framing/main_part.h"

#include <fmt/format.h>

namespace aoscore {

RankingRadius RankingRadii::of(const std::optional<double>& asked_m, const View& view) {
    if (asked_m) return {*asked_m, false, "named by the command or experiment"};
    if (view.radius_m) {
        const std::string rule = automatic_radius_rule(view);
        return {*view.radius_m, false, rule.empty() ? "named by the view" : rule};
    }
    if (!automatic_m_) automatic_m_ = kRadiusPerDiagonal * main_part(scene_).bounds.diagonal();
    return {*automatic_m_, true, main_part_radius_rule()};
}

RankingRadius ranking_radius(const std::optional<double>& asked_m, const View& view, const Scene& scene) {
    return RankingRadii(scene).of(asked_m, view);
}

double search_radius_m(const std::optional<double>& asked_m, const Scene& scene) {
    if (asked_m) return *asked_m;
    for (const View& view : scene.views) {
        if (view.radius_m) return *view.radius_m;
    }
    return ranking_radius({}, View(), scene).metres;
}

std::string radius_warning(const RankingRadius& radius, const View& view) {
    if (!radius.automatic) return {};
    return fmt::format("no radius is named for view {}; ranked, and methods drawn, at {:.4g} m, {}", view.id,
                       radius.metres, radius.rule);
}

}  // namespace aoscore
