#include "jobs/truth_channels.h"

#include "core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {
namespace {

/// In the order of Cause.
constexpr std::array<std::string_view, kCauses> kCauseMeanings{
    "the occlusion whose nearest hit lies outside the picture",
    "that whose nearest hit lies behind what the picture shows there",
    "that whose nearest hit is seen edge-on",
    "that whose nearest hit is visible; the four causes add up to the occlusion",
};

std::vector<std::string> names_of(const Signal& signal) {
    return {signal.channels.begin(), signal.channels.end()};
}

/// The standard error of a signal.
TruthChannel error_row(const Signal& signal, std::string meaning, bool TruthExtras::*gathered_by,
                       std::function<const ImageF&(const Truth&)> number) {
    return {fmt::format("{}.error", signal.id),
            {std::string(signal.error_channel)},
            std::move(meaning),
            gathered_by,
            std::move(number),
            {}};
}

void add_cause_rows(std::vector<TruthChannel>& table) {
    for (std::size_t c = 0; c < kCauses; ++c) {
        table.push_back({cause_channel_id(c),
                         {cause_channel_id(c) + ".Y"},
                         std::string(kCauseMeanings[c]),
                         &TruthExtras::causes,
                         [c](const Truth& t) -> const ImageF& { return t.occlusion_by_cause[c]; },
                         {}});
    }
}

void add_cone_rows(std::vector<TruthChannel>& table) {
    constexpr bool TruthExtras::*kExtra = &TruthExtras::bent_normals;
    const Signal &bent = signal("bent_normal"), &cone = signal("cone_angle");
    table.push_back({std::string(bent.id),
                     names_of(bent),
                     "the mean of the open directions, all directions weighted alike, in view space",
                     kExtra,
                     {},
                     [](const Truth& t) -> const Image<glm::vec3>& { return t.bent_normal; }});
    table.push_back({std::string(cone.id),
                     names_of(cone),
                     "its cone's half angle, radians",
                     kExtra,
                     [](const Truth& t) -> const ImageF& { return t.cone_angle_rad; },
                     {}});
    table.push_back(error_row(bent, "the standard error of the direction, radians", kExtra,
                              [](const Truth& t) -> const ImageF& { return t.bent_error_rad; }));
    table.push_back(error_row(cone, "the standard error of the half angle, radians", kExtra,
                              [](const Truth& t) -> const ImageF& { return t.cone_error_rad; }));
}

std::vector<TruthChannel> make_table() {
    const Signal& visibility = signal(kVisibilitySignal);
    std::vector<TruthChannel> table;
    table.push_back({std::string(visibility.id),
                     names_of(visibility),
                     "the visibility, 0 to 1; 1 where there is no surface",
                     nullptr,
                     [](const Truth& t) -> const ImageF& { return t.visibility[0]; },
                     {}});
    table.push_back(error_row(visibility, "the standard error of visibility", nullptr,
                              [](const Truth& t) -> const ImageF& { return t.standard_error[0]; }));
    add_cause_rows(table);
    table.push_back({std::string(kOneLayerId),
                     {"one_layer.Y"},
                     "the occlusion that a method could find at most which knows one depth layer",
                     &TruthExtras::one_layer_bound,
                     [](const Truth& t) -> const ImageF& { return t.one_layer_bound; },
                     {}});
    add_cone_rows(table);
    return table;
}

template <class Condition>
const TruthChannel& row_where(const Condition& holds, std::string_view name) {
    const auto& table = truth_channels();
    const auto row = std::ranges::find_if(table, holds);
    if (row == table.end()) throw internal_error("the truth has no such channel", std::string(name));
    return *row;
}

}  // namespace

bool TruthChannel::held_by(const Truth& truth) const {
    return number ? !number(truth).empty() : !direction(truth).empty();
}

SignalImage TruthChannel::planes(const Truth& truth) const {
    if (number) return {number(truth)};
    const Image<glm::vec3>& image = direction(truth);
    SignalImage planes(exr_names.size(), ImageF(image.width, image.height));
    for (std::size_t i = 0; i < image.size(); ++i) {
        for (std::size_t axis = 0; axis < planes.size(); ++axis)
            planes[axis].pixels[i] = image.pixels[i][static_cast<glm::length_t>(axis)];
    }
    return planes;
}

const std::vector<TruthChannel>& truth_channels() {
    static const std::vector<TruthChannel> table = make_table();
    return table;
}

const TruthChannel& truth_channel(std::string_view id) {
    return row_where([&](const TruthChannel& row) { return row.id == id; }, id);
}

const TruthChannel& truth_channel_in_files(std::string_view exr_name) {
    return row_where([&](const TruthChannel& row) { return row.exr_names[0] == exr_name; }, exr_name);
}

std::string query_channel(std::size_t q) {
    return fmt::format("V{}.Y", q);
}

std::string query_error_channel(std::size_t q) {
    return fmt::format("SE{}.Y", q);
}

std::string cause_channel_id(std::size_t cause) {
    return fmt::format("cause.{}", kCauseIds[cause]);
}

std::string channels_gathered_by(bool TruthExtras::*extra) {
    std::vector<std::string> lines;
    for (const TruthChannel& row : truth_channels()) {
        if (row.gathered_by == extra)
            lines.push_back(fmt::format("{}, {}", fmt::join(row.exr_names, ", "), row.meaning));
    }
    return fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace aoscore
