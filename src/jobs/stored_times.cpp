#include "jobs/stored_times.h"

#include "core/error.h"
#include "core/strict_json.h"

namespace aoscore {
namespace {

std::vector<double> numbers(StrictObject& object, const char* key) {
    const nlohmann::json& list = object.raw(key);
    if (!list.is_array()) throw file_error("is no list", object.where(key));
    return object.numbers(key, list.size());
}

}  // namespace

bool StoredTimes::serve(const std::optional<TimingGoal>& goal, bool whole_frames) const {
    if (whole_frames && (frame_at_once_ms.empty() || frame_by_pass_ms.empty())) return false;
    if (!goal) return true;
    for (const auto* runs_ms : {&ao_ms, &filter_ms, &lighting_ms, &frame_at_once_ms, &frame_by_pass_ms}) {
        if (!runs_ms->empty() && !goal->reached(*runs_ms)) return false;
    }
    return true;
}

nlohmann::json to_json(const StoredTimes& times) {
    return {{"ao_ms", times.ao_ms},
            {"filter_ms", times.filter_ms},
            {"fixed_pass_ms", times.fixed_pass_ms},
            {"lighting_ms", times.lighting_ms},
            {"frame_at_once_ms", times.frame_at_once_ms},
            {"frame_by_pass_ms", times.frame_by_pass_ms},
            {"ao_processor_ms", times.ao_processor_ms},
            {"layers_processor_ms", times.layers_processor_ms},
            {"gbuffer_ms", times.gbuffer_ms},
            {"gbuffer_bytes", times.gbuffer_bytes}};
}

StoredTimes stored_times_from_json(const nlohmann::json& json, const std::string& where) {
    StrictObject object(json, where);
    StoredTimes times;
    times.ao_ms = numbers(object, "ao_ms");
    times.filter_ms = numbers(object, "filter_ms");
    times.fixed_pass_ms = object.number("fixed_pass_ms", 0, 1e9);
    times.lighting_ms = numbers(object, "lighting_ms");
    times.frame_at_once_ms = numbers(object, "frame_at_once_ms");
    times.frame_by_pass_ms = numbers(object, "frame_by_pass_ms");
    times.ao_processor_ms = numbers(object, "ao_processor_ms");
    times.layers_processor_ms = numbers(object, "layers_processor_ms");
    times.gbuffer_ms = numbers(object, "gbuffer_ms");
    times.gbuffer_bytes = object.number("gbuffer_bytes", 0, 1e15);
    object.finish();
    return times;
}

}  // namespace aoscore
