#include "results/comparable_views.h"

#include <algorithm>
#include <tuple>

namespace aoscore {
namespace {

auto question_of(const ViewRecord& view) {
    return std::tuple(view.radius_m, view.width, view.height);
}

}  // namespace

std::vector<std::vector<const ViewRecord*>> comparable_views(const std::vector<const ViewRecord*>& views) {
    std::vector<std::vector<const ViewRecord*>> groups;
    for (const ViewRecord* view : views) {
        const auto same = std::ranges::find_if(
            groups, [&](const auto& group) { return question_of(*group.front()) == question_of(*view); });
        if (same == groups.end())
            groups.push_back({view});
        else
            same->push_back(view);
    }
    return groups;
}

}  // namespace aoscore
