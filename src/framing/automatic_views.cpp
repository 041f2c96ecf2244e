#include "framing/automatic_views.h"

#include "framing/inside_cameras.h"
#include "framing/outside_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace aoscore {
namespace {

constexpr double kRadiusPerDepth = 0.1;
const std::string kRadiusNote = "its radius is ";
constexpr std::size_t kInside = 3, kOutside = 2;
/// A room is shown from outside where that picture is worth at least this share of the best one from inside;
/// it is then also shown from inside where that picture is worth this share of the one from outside.
constexpr double kLooksIn = 0.95;

double median_depth(const Glance& glance) {
    std::vector<double> depths;
    for (const Glance::Point& p : glance.points) depths.push_back(p.depth_m);
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
}

/// A radius with the rule by which it was found.
struct Radius {
    double metres = 0;
    std::string rule;
};

Radius radius_for(const std::vector<Candidate>& chosen, const Bounds& main) {
    Radius radius{kRadiusPerDiagonal * main.diagonal(), main_part_radius_rule()};
    for (const Candidate& candidate : chosen) {
        if (candidate.glance.points.empty()) continue;
        const double most = kRadiusPerDepth * median_depth(candidate.glance);
        if (most >= radius.metres) continue;
        radius = {most, fmt::format("{:g} % of the median depth of the nearest automatic view",
                                    100 * kRadiusPerDepth)};
    }
    return radius;
}

void add_views(std::vector<View>& views, const std::vector<Candidate>& candidates, const std::string& id,
               const Radius& radius) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        View view = automatic_view_of(i == 0 ? id : fmt::format("{}_{}", id, i + 1), candidates[i].camera);
        if (radius.metres > 0) view.radius_m = radius.metres;
        view.note = kRadiusNote + radius.rule;
        views.push_back(std::move(view));
    }
}

}  // namespace

std::string main_part_radius_rule() {
    return fmt::format("{:g} % of the diagonal of the scene's main part", 100 * kRadiusPerDiagonal);
}

std::string automatic_radius_rule(const View& view) {
    const bool is_stated = view.kind == View::Kind::automatic && view.note.starts_with(kRadiusNote);
    return is_stated ? view.note.substr(kRadiusNote.size()) : "";
}

View automatic_view_of(const std::string& id, const Camera& camera) {
    View view;
    view.id = id;
    view.kind = View::Kind::automatic;
    view.source = "automatic";
    view.options = "--view " + id;
    view.camera = camera;
    return view;
}

std::vector<View> automatic_views(const Scene& scene, double aspect) {
    const Scout scout(scene);
    const MainPart main = main_part(scene);
    const Trial trial{scout, main, kRadiusPerDiagonal * main.bounds.diagonal(), aspect, scene.bounds};
    const RoomSurvey survey = survey_rooms(scout, main.bounds);
    std::vector<Candidate> inside, outside;
    if (has_rooms(survey, main.bounds)) inside = inside_cameras(trial, survey, kInside);
    if (inside.empty()) {
        outside = outside_cameras(trial, Around::three_quarters, kOutside);
    } else {
        outside = outside_cameras(trial, Around::straight_too, 1);
        if (outside.front().worth < kLooksIn * inside.front().worth) outside.clear();
        inside.resize(std::min(inside.size(), kInside - outside.size()));
        for (const Candidate& look : outside)
            std::erase_if(inside, [&](const Candidate& c) { return c.worth < kLooksIn * look.worth; });
    }
    std::vector<Candidate> all = outside;
    all.insert(all.end(), inside.begin(), inside.end());
    const Radius radius = radius_for(all, main.bounds);
    std::vector<View> views;
    add_views(views, outside, "auto_outside", radius);
    add_views(views, inside, "auto_inside", radius);
    return views;
}

}  // namespace aoscore
