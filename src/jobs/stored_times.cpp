#include "jobs/stored_times.h"

#include "core/error.h"
#include "core/strict_json.h"

#include <array>
#include <utility>

namespace aoscore {
namespace {

using Pass = std::pair<const char*, PassRuns StoredTimes::*>;
constexpr std::array kPasses{Pass{"ao", &StoredTimes::ao},
                             Pass{"filter", &StoredTimes::filter},
                             Pass{"fixed_pass", &StoredTimes::fixed_pass},
                             Pass{"lighting", &StoredTimes::lighting},
                             Pass{"frame_at_once", &StoredTimes::frame_at_once},
                             Pass{"frame_by_pass", &StoredTimes::frame_by_pass},
                             Pass{"gbuffer", &StoredTimes::gbuffer}};

std::vector<double> numbers(StrictObject& object, const char* key) {
    const nlohmann::json& list = object.raw(key);
    if (!list.is_array()) throw file_error("is no list", object.where(key));
    return object.numbers(key, list.size());
}

}  // namespace

bool StoredTimes::serve(const std::optional<TimingGoal>& goal, bool whole_frames) const {
    if (whole_frames && (frame_at_once.empty() || frame_by_pass.empty())) return false;
    if (!goal) return true;
    for (const PassRuns* runs : {&ao, &filter, &lighting, &frame_at_once, &frame_by_pass}) {
        if (!runs->empty() && !goal->reached(runs->ms)) return false;
    }
    return true;
}

nlohmann::json to_json(const PassRuns& runs) {
    return {{"ms", runs.ms}, {"processor_ms", runs.processor_ms}};
}

PassRuns pass_runs_from_json(const nlohmann::json& json, const std::string& where) {
    StrictObject object(json, where);
    PassRuns runs{numbers(object, "ms"), numbers(object, "processor_ms")};
    object.finish();
    return runs;
}

nlohmann::json to_json(const StoredTimes& times) {
    nlohmann::json object{{"layers_processor_ms", times.layers_processor_ms},
                          {"gbuffer_bytes", times.gbuffer_bytes}};
    for (const auto& [name, runs] : kPasses) object[name] = to_json(times.*runs);
    return object;
}

StoredTimes stored_times_from_json(const nlohmann::json& json, const std::string& where) {
    StrictObject object(json, where);
    StoredTimes times;
    for (const auto& [name, runs] : kPasses)
        times.*runs = pass_runs_from_json(object.raw(name), object.where(name));
    times.layers_processor_ms = numbers(object, "layers_processor_ms");
    times.gbuffer_bytes = object.number("gbuffer_bytes", 0, 1e15);
    object.finish();
    return times;
}

}  // namespace aoscore
