#include "tuning/preset_files.h"

#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "screen/method/preset_tuning.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

json filter_json(const PresetFilter& filter) {
    if (filter.preset == "default") return filter.filter;
    return {{"filter", filter.filter}, {"preset", filter.preset}};
}

/// What the preset is worth: on views left out by scenes, where there are several, else one by one.
PresetTuning tuning_of(const MethodTuning& tuning, const TunedMethod& t, const TuningResults& results,
                       const TuningPlan& plan) {
    PresetTuning record;
    record.from = tuning.cell.preset;
    record.definition = plan.definition;
    record.metric = plan.metric;
    record.views = static_cast<int>(results.views.size());
    record.scenes = static_cast<int>(plan.scenes.size());
    record.published = t.published_loss;
    record.fitted = t.fitted_loss;
    if (t.held_out.empty()) return record;
    const HeldOut& held_out = t.held_out.back();
    record.left_out = held_out.groups;
    record.held_out = held_out.loss;
    record.change = held_out.gain;
    record.low = held_out.low;
    record.high = held_out.high;
    return record;
}

/// Adds the presets of a tuning to a method's file, in the form of its descriptor's.
void add_presets_to(json& file, const MethodTuning& tuning, const MethodDescriptor& method,
                    const TuningResults& results, const TuningPlan& plan) {
    for (const TunedMethod& t : tuning.budgets) {
        const std::string id = tuned_preset_id(tuning.cell.preset, t.budget);
        json values = method.presets.at(tuning.cell.preset);
        for (const auto& [parameter, value] : tuning.cell.overrides) values[parameter] = json(value);
        for (const auto& [parameter, value] : values_of(tuning.axes, t.settings))
            values[parameter] = json(value);
        file["presets"][id] = std::move(values);
        file["preset_filters"][id] = filter_json(filter_of(tuning.cell, method));
        file["tunings"][id] = tuning_json(tuning_of(tuning, t, results, plan));
        const auto absolute = method.absolute_presets.find(tuning.cell.preset);
        if (absolute != method.absolute_presets.end()) file["absolute_presets"][id] = absolute->second;
    }
}

}  // namespace

std::string tuned_preset_id(const std::string& from, const Budget& budget) {
    std::string id = (from == "default" ? "" : from + "-") + "tuned";
    if (budget.fetches) id += fmt::format("-{:g}", *budget.fetches);
    if (budget.ms) id += fmt::format("-{:g}ms", *budget.ms);
    std::ranges::replace(id, '.', '-');
    return id;
}

ParameterValues values_of(const std::vector<SearchAxis>& axes, const Settings& settings) {
    ParameterValues values;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].whole)
            values[axes[i].parameter] = static_cast<std::int64_t>(settings[i]);
        else
            values[axes[i].parameter] = settings[i];
    }
    return values;
}

std::map<std::string, json> preset_files(const TuningResults& results, const TuningPlan& plan) {
    std::vector<std::string> warnings;
    const Registry registry = load_registry(plan.methods_dir, {}, warnings);
    std::map<std::string, json> files;
    for (const MethodTuning& tuning : results.methods) {
        json& file = files[tuning.cell.method];
        file["method"] = tuning.cell.method;
        add_presets_to(file, tuning, find_method(registry.methods, tuning.cell.method), results, plan);
    }
    return files;
}

std::vector<std::filesystem::path> install_presets(const TuningResults& results, const TuningPlan& plan) {
    const std::filesystem::path methods = data_dir() / "shaders" / "methods";
    std::vector<std::filesystem::path> written;
    for (const auto& [method, presets] : preset_files(results, plan)) {
        if (!std::filesystem::is_directory(methods / method))
            throw usage_error(method + " is no method of the program's own", "--install",
                              "such methods alone");
        written.push_back(methods / method / kTunedPresets);
        write_atomically(written.back(), presets.dump(2) + "\n");
    }
    return written;
}

}  // namespace aoscore
