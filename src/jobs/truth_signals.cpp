#include "jobs/truth_signals.h"

#include "core/error.h"
#include "core/known_names.h"
#include "metrics/measures/angle_errors.h"

#include <glm/trigonometric.hpp>

#include <array>

namespace aoscore {
namespace {

SignalImage planes_of(const Image<glm::vec3>& image) {
    SignalImage planes(3, ImageF(image.width, image.height));
    for (std::size_t i = 0; i < image.size(); ++i) {
        for (std::size_t axis = 0; axis < planes.size(); ++axis)
            planes[axis].pixels[i] = image.pixels[i][static_cast<glm::length_t>(axis)];
    }
    return planes;
}

/// The way in which the truth gives one of the signals of core/signal.h.
struct Row {
    std::string_view id;
    bool TruthExtras::*gathered_by;
    SignalImage (*image)(const Truth&);
    ImageF Truth::*standard_error_rad;
};

constexpr std::array<Row, 2> kRows{{
    {"bent_normal", &TruthExtras::bent_normals, [](const Truth& t) { return planes_of(t.bent_normal); },
     &Truth::bent_error_rad},
    {"cone_angle", &TruthExtras::bent_normals, [](const Truth& t) { return SignalImage{t.cone_angle_rad}; },
     &Truth::cone_error_rad},
}};

SignalRecord recorded(const Row& row, const Truth& truth, const Mask& valid) {
    SignalRecord record{std::string(row.id), 0, 0};
    const ImageF& errors = truth.*row.standard_error_rad;
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
    for (const std::string& id : signals)
        extras.*row_of(kRows, id, "no signal of the truth").gathered_by = true;
    return extras;
}

std::vector<std::string> held_signals(const Truth& truth) {
    std::vector<std::string> ids;
    for (const Row& row : kRows) {
        if (!(truth.*row.standard_error_rad).empty()) ids.emplace_back(row.id);
    }
    return ids;
}

TruthSignal truth_signal(const Truth& truth, std::string_view id) {
    const Row& row = row_of(kRows, id, "no signal of the truth");
    const ImageF& standard_error = truth.*row.standard_error_rad;
    if (standard_error.empty()) throw internal_error("the truth was not asked for", std::string(id));
    return {row.image(truth), &standard_error};
}

std::vector<SignalRecord> recorded_signals(const Truth& truth, const Mask& valid) {
    std::vector<SignalRecord> records;
    for (const std::string& id : held_signals(truth))
        records.push_back(recorded(*find_row(kRows, id), truth, valid));
    return records;
}

}  // namespace aoscore
