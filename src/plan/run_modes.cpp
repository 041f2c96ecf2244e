#include "plan/run_modes.h"

#include "core/error.h"
#include "core/known_names.h"
#include "screen/gbuffer/precision.h"

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

template <class Mode>
using Names = std::vector<std::pair<std::string, Mode>>;

// `names` must have every value of the mode.
template <class Mode>
RunModeOption option(std::string_view id, std::string_view meaning, Mode RunModes::*member,
                     const Names<Mode>& names) {
    RunModeOption row{id, meaning, {}, {}, {}};
    for (const auto& [name, value] : names) row.choices.push_back(name);
    row.choose = [member, names, id, choices = row.choices](RunModes& modes, const std::string& choice) {
        const auto found =
            std::ranges::find_if(names, [&](const auto& named) { return named.first == choice; });
        if (found == names.end()) throw unknown_name("no such choice", choice, choices, std::string(id));
        modes.*member = found->second;
    };
    row.chosen = [member, names](const RunModes& modes) {
        for (const auto& [name, value] : names) {
            if (modes.*member == value) return name;
        }
        return std::string();
    };
    return row;
}

RunModeOption guard_band_option() {
    return {
        "guard-band",
        "A band around the picture that methods see, in pixels or per cent of the picture; it is not scored",
        {"0", "64", "10%"},
        [](RunModes& modes, const std::string& text) { modes.guard_band = parse_guard_band(text); },
        [](const RunModes& modes) { return text_of(modes.guard_band); }};
}

Names<Precision> precision_names() {
    Names<Precision> names;
    for (const PrecisionFormat& format : precision_formats()) names.emplace_back(format.id, format.precision);
    return names;
}

}  // namespace

void RunModes::apply_to(MethodRequest& request) const {
    request.border = border;
    request.normals = normals;
    request.resolution = resolution;
    request.precision = precision;
    request.guard_band = guard_band;
}

const std::vector<RunModeOption>& run_mode_options() {
    static const std::vector<RunModeOption> table{
        option<Border>("border",
                       "What a tap outside of the picture reads: the far plane, or the nearest pixel",
                       &RunModes::border, {{"far", Border::far}, {"clamp", Border::clamp}}),
        option<Normals>("normals", "Where normals come from", &RunModes::normals,
                        {{"as-described", Normals::as_described},
                         {"geometric", Normals::geometric},
                         {"smooth", Normals::smooth},
                         {"from-depth", Normals::from_depth},
                         {"from-depth-accurate", Normals::from_depth_accurate}}),
        option<Resolution>("resolution", "Which pixels are shaded, from which G-buffer",
                           &RunModes::resolution,
                           {{"full", Resolution::full},
                            {"half", Resolution::half},
                            {"dual", Resolution::dual},
                            {"half-gbuffer", Resolution::half_gbuffer}}),
        option<Precision>("precision", "How depth and normals are stored", &RunModes::precision,
                          precision_names()),
        guard_band_option(),
    };
    return table;
}

void choose_as_file_says(const RunModeOption& mode, RunModes& modes, const std::string& choice,
                         const std::string& where) {
    try {
        mode.choose(modes, choice);
    } catch (const Error& e) {
        throw file_error(e.what(), where);
    }
}

std::map<std::string, std::string> unusual_modes(const RunModes& modes) {
    std::map<std::string, std::string> unusual;
    for (const RunModeOption& mode : run_mode_options()) {
        const std::string chosen = mode.chosen(modes);
        if (chosen != mode.choices.front()) unusual.emplace(mode.id, chosen);
    }
    return unusual;
}

}  // namespace aoscore
