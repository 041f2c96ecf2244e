#include "page/sections/cell_command.h"

#include "core/json_text.h"
#include "core/printable.h"
#include "core/processes/shell.h"
#include "page/document/page_template.h"
#include "page/live/live_packing.h"
#include "page/section.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace aoscore {
namespace {

// Changes of a cell that are options of their own; all others are parameters.
constexpr std::array<std::string_view, 5> kModeOptions = {"border", "normals", "resolution", "precision",
                                                          "guard-band"};
constexpr std::string_view kSignalChange = "signal";
constexpr std::string_view kUsualSeed = "1";
constexpr const char* kSky = "sky";

/// The text between two others of a command; empty where it lacks the first.
std::string between(const std::string& command, std::string_view from, std::string_view to) {
    const std::size_t start = command.find(from);
    if (start == std::string::npos) return {};
    const std::size_t first = start + from.size();
    return command.substr(first, command.find(to, first) - first);
}

bool is_image_of_a_folder(const Results& results, const CellRecord& cell) {
    return results.command.find(" --contestant ") != std::string::npos && cell.ao.runs_ms.empty();
}

bool has_preset_of_a_file(const Results& results) {
    const std::string preset = between(results.command, " --preset ", " --");
    return preset.find(".json") != std::string::npos;
}

/// What a cell's id adds to its view, method and preset: "/FILTER/CHANGE=VALUE,CHANGE=VALUE"; may be empty.
std::string additions_of(const CellRecord& cell) {
    const std::string opening = cell.view_key + "/" + cell.method + "/" + cell.preset;
    return cell.id.starts_with(opening) ? cell.id.substr(opening.size()) : std::string();
}

std::string change_option(std::string_view change) {
    const std::size_t equals = change.find('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view id = change.substr(0, equals);
    const std::string value = shell_quoted(std::string(change.substr(equals + 1)));
    if (id == kSignalChange) return " --signals " + value;
    if (std::ranges::find(kModeOptions, id) != kModeOptions.end()) return fmt::format(" --{} {}", id, value);
    return " --set " + shell_quoted(std::string(change));
}

/// The options for what additions_of() says.
std::string addition_options(const CellRecord& cell) {
    std::string rest = additions_of(cell), options;
    const std::string filter = "/" + cell.filter;
    if (rest == filter || rest.starts_with(filter + "/")) {
        options += " --filter " + shell_quoted(cell.filter);
        rest.erase(0, filter.size());
    }
    if (rest.starts_with("/")) rest.erase(0, 1);
    for (std::size_t start = 0; start < rest.size();) {
        const std::size_t end = std::min(rest.find(',', start), rest.size());
        options += change_option(std::string_view(rest).substr(start, end - start));
        start = end + 1;
    }
    return options;
}

std::string accuracy_options(const ViewRecord& view) {
    if (view.score_error) return fmt::format(" --score-error {}", *view.score_error);
    const std::string samples =
        fmt::format(" --samples {}", between(view.truth_command + " ", " --samples ", " "));
    return view.max_error ? fmt::format("{} --error {}", samples, *view.max_error) : samples;
}

/// What lit the cell; nothing where its picture is named by a definition, which no command says.
std::string environment_options(const Results& results, const ViewRecord& view, const CellRecord& cell) {
    if (!view.light || cell.light.empty()) return {};
    if (view.light->environment == kSky) return fmt::format(" --environment {}", kSky);
    std::string options;
    for (const char* option : {" --environment ", " --environment-turn "}) {
        const std::string value = between(results.command + " ", option, " ");
        if (!value.empty()) options += option + value;
    }
    return options;
}

bool keeps_own_lengths(const CellRecord& cell) {
    return std::ranges::any_of(cell.lengths, [](const LengthRecord& length) {
        return length.origin == std::string_view(LengthRecord::kOwn);
    });
}

}  // namespace

std::string cell_command(const Results& results, const ViewRecord& view, const CellRecord& cell) {
    const std::string place = between(view.truth_command, "aoscore reference ", " --radius ");
    if (place.empty() || is_image_of_a_folder(results, cell) || has_preset_of_a_file(results))
        return results.command;
    const std::string seed = between(view.truth_command + " ", " --seed ", " ");
    const std::string folder = between(results.command + " ", " --methods-dir ", " ");
    std::string command = "aoscore ";
    if (seed != kUsualSeed) command += fmt::format("--seed {} ", seed);
    command += fmt::format("score {} --radius {}{}", place, view.radius_m, accuracy_options(view));
    if (!folder.empty()) command += " --methods-dir " + folder;
    command += fmt::format(" --methods {} --preset {}", shell_quoted(cell.method), shell_quoted(cell.preset));
    if (keeps_own_lengths(cell)) command += " --own-parameters";
    return command + addition_options(cell) + environment_options(results, view, cell);
}

std::string command_block(const Results& results) {
    nlohmann::json commands = nlohmann::json::object();
    for (const CellRecord& cell : results.cells)
        commands[cell.id] = cell_command(results, find_view(results, cell.view_key), cell);
    return data_block("commands", pack_text(printable_lines(json_text(commands))));
}

}  // namespace aoscore
