#include "jobs/truth_signals.h"

#include "core/error.h"
#include "jobs/truth_channels.h"
#include "metrics/measures/angle_errors.h"

#include <glm/trigonometric.hpp>

namespace aoscore {
namespace {

/// The standard error of the signal's angle, radians.
const ImageF& error_of_signal(const Truth& truth, std::string_view id) {
    return truth_channel_in_files(signal(id).error_channel).number(truth);
}

SignalRecord recorded(const std::string& id, const Truth& truth, const Mask& valid) {
    SignalRecord record{id, 0, 0};
    const ImageF& errors = error_of_signal(truth, id);
    double sum = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (valid.pixels[i] == 0 || errors.pixels[i] > kKnownWithin_rad) continue;
        sum += static_cast<double>(errors.pixels[i]);
        ++record.known_pixels;
    }
    if (record.known_pixels > 0)
        record.mean_standard_error_deg = glm::degrees(sum / static_cast<double>(record.known_pixels));
    return record;
}

}  // namespace

TruthExtras extras_for(std::span<const std::string> signals) {
    TruthExtras extras;
    for (const std::string& id : signals) {
        if (const auto extra = truth_channel(signal(id).id).gathered_by) extras.*extra = true;
    }
    return extras;
}

std::vector<std::string> held_signals(const Truth& truth) {
    std::vector<std::string> ids = further_signals();
    std::erase_if(ids, [&](const std::string& id) { return !truth_channel(id).held_by(truth); });
    return ids;
}

TruthSignal truth_signal(const Truth& truth, std::string_view id) {
    const TruthChannel& channel = truth_channel(id);
    if (!channel.held_by(truth)) throw internal_error("the truth was not asked for", std::string(id));
    return {channel.planes(truth), &error_of_signal(truth, id)};
}

std::vector<SignalRecord> recorded_signals(const Truth& truth, const Mask& valid) {
    std::vector<SignalRecord> records;
    for (const std::string& id : held_signals(truth)) records.push_back(recorded(id, truth, valid));
    return records;
}

}  // namespace aoscore
