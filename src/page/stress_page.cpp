#include "page/stress_page.h"

#include "core/files.h"
#include "core/folders.h"
#include "core/known_names.h"
#include "page/document/html_document.h"
#include "page/document/number_text.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"
#include "page/stress_strips.h"
#include "results/stress_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The look of a cell.
struct Grade {
    const char* style;  ///< its class in the style sheet
    const char* mark;   ///< readable without colours
};

bool by_nature(const StressResults& results, const StressAxisRecord& axis, const StressCell& cell) {
    const auto subject = find_row(results.subjects, cell.subject);
    const bool numbers =
        cell.error.empty() && cell.nonfinite == 0 && cell.out_of_range == 0 && cell.background == 0;
    return numbers && subject != nullptr && subject->limits.contains(axis.id);
}

Grade grade_of(const StressResults& results, const StressAxisRecord& axis, const StressCell& cell) {
    if (!cell.skipped.empty()) return {"skipped", ""};
    if (!cell.error.empty() || cell.nonfinite > 0 || cell.out_of_range > 0 || cell.background > 0)
        return {"faulty", "×"};
    if (!cell.breaks.empty()) {
        const bool far = cell.deviation.value_or(0) > 4 * axis.limit;
        if (by_nature(results, axis, cell)) return far ? Grade{"nature far", "•"} : Grade{"nature", "•"};
        return far ? Grade{"breaks far", "!"} : Grade{"breaks", "!"};
    }
    if (!cell.deviation) return {"unjudged", ""};
    return cell.deviation > axis.limit / 4 ? Grade{"near", ""} : Grade{"holds", ""};
}

const StressCell& cell_of(const StressSettingRecord& setting, const std::string& subject) {
    static const StressCell none{"", "was not tried", "", 0, 0, 0, {}, {}, {}, {}, ""};
    const StressCell* found = find_row(setting.cells, subject, &StressCell::subject);
    return found == nullptr ? none : *found;
}

std::string state_text(const StressCell& cell) {
    if (!cell.skipped.empty()) return cell.skipped;
    if (!cell.error.empty()) return "does not run: " + cell.error;
    if (!cell.breaks.empty()) return cell.breaks;
    return cell.deviation ? "holds, deviation " + fixed_text(cell.deviation, 4)
                          : "holds; too few pixels for a deviation";
}

std::string break_text(const StressAxisRecord& axis, const std::string& subject) {
    std::vector<std::string> texts;
    for (const StressBreak& found : first_breaks(axis, subject)) texts.push_back(found.setting->label);
    return fmt::format("{}", fmt::join(texts, "; "));
}

bool breaks(const StressResults& results, const StressAxisRecord& axis) {
    return std::ranges::any_of(results.subjects, [&](const StressSubjectRecord& subject) {
        return !break_text(axis, subject.id).empty();
    });
}

/// The kinds of stress that break nothing, within a sentence.
std::vector<std::string> whole_axes(const StressResults& results) {
    std::vector<std::string> labels;
    for (const StressAxisRecord& axis : results.axes) {
        if (breaks(results, axis)) continue;
        labels.push_back(axis.label);
        char& first = labels.back().front();
        first = static_cast<char>(std::tolower(static_cast<unsigned char>(first)));
    }
    return labels;
}

json head_model(const StressResults& results) {
    json axes = json::array(), settings = json::array();
    for (const StressAxisRecord& axis : results.axes) {
        axes.push_back({{"id", axis.id},
                        {"label", axis.label},
                        {"meaning", axis.meaning},
                        {"columns", std::to_string(axis.settings.size())},
                        {"limit", short_text(axis.limit)},
                        {"breaks", breaks(results, axis)},
                        {"same_picture", axis.judgement == "same picture"}});
        for (const StressSettingRecord& setting : axis.settings) {
            settings.push_back({{"label", setting.label},
                                {"unstressed", setting.unstressed},
                                {"first", &setting == &axis.settings.front()}});
        }
    }
    const std::vector<std::string> whole = whole_axes(results);
    return {{"axes", axes},
            {"settings", settings},
            {"has_whole", !whole.empty()},
            {"whole", fmt::format("{}", fmt::join(whole, "; "))}};
}

json rows_model(const StressResults& results) {
    json rows = json::array();
    for (const StressSubjectRecord& subject : results.subjects) {
        json cells = json::array(), first_breaks_of = json::array();
        for (std::size_t a = 0; a < results.axes.size(); ++a) {
            const StressAxisRecord& axis = results.axes[a];
            for (std::size_t s = 0; s < axis.settings.size(); ++s) {
                const StressSettingRecord& setting = axis.settings[s];
                const StressCell& cell = cell_of(setting, subject.id);
                const Grade grade = grade_of(results, axis, cell);
                cells.push_back({{"style", std::string(grade.style) + (s == 0 ? " first" : "")},
                                 {"mark", grade.mark},
                                 {"place", fmt::format("{}-{}", a, s)},
                                 {"title", fmt::format("{}, {} {}: {}", subject.label, axis.label,
                                                       setting.label, state_text(cell))}});
            }
            if (!breaks(results, axis)) continue;
            const std::string text = break_text(axis, subject.id);
            first_breaks_of.push_back({{"text", text.empty() ? "–" : text},
                                       {"broken", !text.empty()},
                                       {"nature", subject.limits.contains(axis.id)}});
        }
        rows.push_back({{"id", subject.id},
                        {"label", subject.label},
                        {"kind", subject.kind},
                        {"cells", cells},
                        {"breaks", first_breaks_of}});
    }
    return rows;
}

json limits_model(const StressResults& results) {
    json list = json::array();
    for (const StressSubjectRecord& subject : results.subjects) {
        json reasons = json::array();
        for (const StressAxisRecord& axis : results.axes) {
            const auto reason = subject.limits.find(axis.id);
            if (reason != subject.limits.end())
                reasons.push_back({{"axis", axis.label}, {"reason", reason->second}});
        }
        if (!reasons.empty()) list.push_back({{"label", subject.label}, {"reasons", reasons}});
    }
    return list;
}

struct Counts {
    std::size_t cells = 0, breaking = 0, nature = 0, faulty = 0;
};

Counts count(const StressResults& results) {
    Counts counts;
    for (const StressAxisRecord& axis : results.axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            for (const StressCell& cell : setting.cells) {
                if (!cell.skipped.empty()) continue;
                ++counts.cells;
                if (cell.breaks.empty()) continue;
                const std::string style = grade_of(results, axis, cell).style;
                ++counts.breaking;
                counts.faulty += style == "faulty";
                counts.nature += style.starts_with("nature");
            }
        }
    }
    return counts;
}

json number(std::optional<double> value, int decimals) {
    return fixed_text(value, decimals);
}

// The details that a cell opens: texts and places in the strips.
json data_model(const StressResults& results, const fs::path& folder) {
    json axes = json::array();
    for (const StressAxisRecord& axis : results.axes) {
        json settings = json::array();
        for (const StressSettingRecord& setting : axis.settings) {
            const StressStrip strip = make_stress_strip(setting, folder);
            json cells = json::object();
            for (const StressCell& cell : setting.cells) {
                const auto place = strip.places.find(cell.subject);
                cells[cell.subject] = {{"state", state_text(cell)},
                                       {"rmse", number(cell.rmse, 4)},
                                       {"mean", number(cell.mean, 4)},
                                       {"time", number(cell.time_ms, 1)},
                                       {"nonfinite", cell.nonfinite},
                                       {"place", place == strip.places.end() ? -1 : place->second}};
            }
            settings.push_back({{"label", setting.label},
                                {"unstressed", setting.unstressed},
                                {"size", fmt::format("{}x{}", setting.width, setting.height)},
                                {"triangles", count_text(setting.triangles)},
                                {"compared", count_text(setting.compared_pixels)},
                                {"width", strip.width},
                                {"height", strip.height},
                                {"visibility", strip.visibility},
                                {"deviation", strip.deviation},
                                {"cells", std::move(cells)}});
        }
        axes.push_back({{"label", axis.label},
                        {"meaning", axis.meaning},
                        {"same_picture", axis.judgement == "same picture"},
                        {"settings", std::move(settings)}});
    }
    json subjects = json::object();
    for (const StressSubjectRecord& subject : results.subjects) {
        json limits = json::object();
        for (std::size_t a = 0; a < results.axes.size(); ++a) {
            const auto reason = subject.limits.find(results.axes[a].id);
            if (reason != subject.limits.end()) limits[std::to_string(a)] = reason->second;
        }
        subjects[subject.id] = {{"label", subject.label}, {"limits", std::move(limits)}};
    }
    return {{"axes", std::move(axes)}, {"subjects", std::move(subjects)}, {"range", kStressDeviationRange}};
}

}  // namespace

fs::path write_stress_page(const fs::path& results_folder) {
    const StressResults results = read_stress_results(results_folder);
    const fs::path parts = data_dir() / "reports" / "stress";
    const Counts counts = count(results);
    json model = head_model(results);
    model["data"] = script_json(data_model(results, results_folder));
    model["rows"] = rows_model(results);
    model["limits"] = limits_model(results);
    model["cells"] = count_text(counts.cells);
    model["breaking"] = count_text(counts.breaking);
    model["nature"] = count_text(counts.nature);
    model["faulty"] = count_text(counts.faulty);
    model["unexplained"] = count_text(counts.breaking - counts.nature - counts.faulty);
    model["version"] = results.program_version;
    model["created"] = results.created_utc;
    model["command"] = results.command;
    model["cpu"] = results.cpu;
    model["threads"] = std::to_string(results.threads);
    model["renderer"] = results.gl_renderer;
    model["scene"] = results.scene;
    model["size"] = std::to_string(results.size);
    model["samples"] = std::to_string(results.samples);
    model["filtered_method"] = results.filtered_method;
    model["least_pixels"] = std::to_string(results.least_compared_pixels);
    model["seconds"] = fixed_text(results.total_seconds, 0);
    model["cpu_seconds"] = fixed_text(results.cpu_seconds, 0);
    const fs::path frame = parts / "template.html";
    const fs::path path = results_folder / "index.html";
    write_atomically(
        path,
        html_text({"numerical stress",
                   read_file(page_folder() / "style" / "page.css") + read_file(parts / "style.css"),
                   read_file(parts / "script.js"), fill_template(read_file(frame), model, frame.string())}));
    return path;
}

}  // namespace aoscore
