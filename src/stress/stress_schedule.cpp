#include "stress/stress_schedule.h"

#include "core/known_names.h"
#include "core/log.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

std::vector<StressAxis> chosen_axes(const StressPlan& plan) {
    for (const std::string& id : plan.axes) row_of(stress_axes(), id, "no stress axis", "--axes");
    std::vector<StressAxis> chosen;
    for (const StressAxis& axis : stress_axes()) {
        if (plan.axes.empty() || std::ranges::find(plan.axes, axis.id) != plan.axes.end())
            chosen.push_back(axis);
    }
    return chosen;
}

// The unstressed setting and those at either end, without pictures too large to be traced, which take long.
std::vector<StressSetting> ends_of(std::vector<StressSetting> settings, int size) {
    while (!stress_case(settings.back(), size).has_truth) settings.pop_back();
    std::vector<StressSetting> ends;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (i == 0 || i + 1 == settings.size() || settings[i].unstressed()) ends.push_back(settings[i]);
    }
    return ends;
}

std::vector<StressAxis> planned_axes(const StressPlan& plan) {
    std::vector<StressAxis> axes = chosen_axes(plan);
    if (plan.ends_only) {
        for (StressAxis& axis : axes) axis.settings = ends_of(axis.settings, plan.size);
    }
    return axes;
}

Registry planned_registry(const StressPlan& plan) {
    std::vector<std::string> warnings;
    Registry registry = load_registry(plan.methods_dir, plan.methods, warnings);
    for (const std::string& warning : warnings) log_warning(warning);
    return registry;
}

}  // namespace

StressSchedule::StressSchedule(const StressPlan& plan)
    : plan_(plan),
      registry_(planned_registry(plan)),
      subjects_(stress_subjects(registry_, plan.methods)),
      axes_(planned_axes(plan)),
      store_(ArtifactStore::folder_in(plan.cache)),
      unstressed_(plan, subjects_, tools_) {}

std::size_t StressSchedule::setting_count() const {
    std::size_t count = 0;
    for (const StressAxis& axis : axes_) count += axis.settings.size();
    return count;
}

std::string StressSchedule::key_of(const StressAxis& axis, const StressSetting& setting) {
    return fmt::format("{}/{}", axis.id, setting.id);
}

StressWork StressSchedule::work_of(const StressAxis& axis, const StressSetting& setting) {
    return StressWork(plan_, subjects_, stress_case(setting, plan_.size), axis.judgement,
                      key_of(axis, setting), tools_);
}

}  // namespace aoscore
