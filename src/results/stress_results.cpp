#include "results/stress_results.h"

#include "core/files.h"
#include "core/json_text.h"
#include "results/record_json.h"

#include <algorithm>

namespace aoscore {

template <class Visit, RecordOf<StressCell> Record>
void visit_members(Visit& visit, Record& cell) {
    visit("subject", cell.subject);
    visit("skipped", cell.skipped);
    visit("error", cell.error);
    visit("nonfinite", cell.nonfinite);
    visit("out_of_range", cell.out_of_range);
    visit("background", cell.background);
    visit("deviation", cell.deviation);
    visit("rmse", cell.rmse);
    visit("mean", cell.mean);
    visit("time_ms", cell.time_ms);
    visit("breaks", cell.breaks);
}

template <class Visit, RecordOf<StressSettingRecord> Record>
void visit_members(Visit& visit, Record& setting) {
    visit("id", setting.id);
    visit("label", setting.label);
    visit("unstressed", setting.unstressed);
    visit("key", setting.key);
    visit("width", setting.width);
    visit("height", setting.height);
    visit("triangles", setting.triangles);
    visit("surface_pixels", setting.surface_pixels);
    visit("compared_pixels", setting.compared_pixels);
    visit("disagreeing_share", setting.disagreeing_share);
    visit("truth_samples", setting.truth_samples);
    visit("truth_seconds", setting.truth_seconds);
    visit("gbuffer_ms", setting.gbuffer_ms);
    visit("seconds", setting.seconds);
    visit("images", setting.images);
    visit("cells", setting.cells);
}

template <class Visit, RecordOf<StressAxisRecord> Record>
void visit_members(Visit& visit, Record& axis) {
    visit("id", axis.id);
    visit("label", axis.label);
    visit("meaning", axis.meaning);
    visit("judgement", axis.judgement);
    visit("limit", axis.limit);
    visit("settings", axis.settings);
}

template <class Visit, RecordOf<StressSubjectRecord> Record>
void visit_members(Visit& visit, Record& subject) {
    visit("id", subject.id);
    visit("label", subject.label);
    visit("kind", subject.kind);
    visit("preset", subject.preset);
    visit("limits", subject.limits);
}

template <class Visit, RecordOf<StressResults> Record>
void visit_members(Visit& visit, Record& results) {
    visit("program_version", results.program_version);
    visit("created_utc", results.created_utc);
    visit("command", results.command);
    visit("cpu", results.cpu);
    visit("threads", results.threads);
    visit("gl_renderer", results.gl_renderer);
    visit("seed", results.seed);
    visit("size", results.size);
    visit("samples", results.samples);
    visit("scene", results.scene);
    visit("filtered_method", results.filtered_method);
    visit("least_compared_pixels", results.least_compared_pixels);
    visit("total_seconds", results.total_seconds);
    visit("cpu_seconds", results.cpu_seconds);
    visit("subjects", results.subjects);
    visit("axes", results.axes);
}

namespace {

constexpr const char* kStressFile = "stress.json";

}  // namespace

void write_stress_results(const StressResults& results, const std::filesystem::path& folder) {
    nlohmann::json object = record_json::checked_json(results, kStressFile);
    object["schema_version"] = StressResults::kSchemaVersion;
    write_atomically(folder / kStressFile, json_text(object, 1) + "\n");
}

StressResults read_stress_results(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kStressFile;
    const nlohmann::json object = parse_json_file(file);
    return record_json::versioned_record_from_json<StressResults>(object, file.string());
}

bool has_stress_results(const std::filesystem::path& folder) {
    std::error_code ec;
    return std::filesystem::is_regular_file(folder / kStressFile, ec);
}

nlohmann::json to_json(const StressSettingRecord& setting) {
    return record_json::checked_json(setting, setting.id);
}

StressSettingRecord stress_setting_from_json(const nlohmann::json& stored, const std::string& where) {
    return record_json::record_from_json<StressSettingRecord>(stored, where);
}

nlohmann::json to_json(const StressCell& cell) {
    return record_json::checked_json(cell, cell.subject);
}

StressCell stress_cell_from_json(const nlohmann::json& stored, const std::string& where) {
    return record_json::record_from_json<StressCell>(stored, where);
}

std::vector<StressBreak> first_breaks(const StressAxisRecord& axis, const std::string& subject) {
    const auto& settings = axis.settings;
    const auto base = std::find_if(settings.begin(), settings.end(),
                                   [](const StressSettingRecord& s) { return s.unstressed; });
    const auto broken = [&](const StressSettingRecord& setting) -> const StressCell* {
        for (const StressCell& cell : setting.cells) {
            if (cell.subject == subject && !cell.breaks.empty()) return &cell;
        }
        return nullptr;
    };
    std::vector<StressBreak> found;
    for (auto below = base; below != settings.begin();) {
        --below;
        if (const StressCell* cell = broken(*below)) {
            found.push_back({&*below, cell});
            break;
        }
    }
    for (auto above = base; above != settings.end(); ++above) {
        if (const StressCell* cell = broken(*above)) {
            found.push_back({&*above, cell});
            break;
        }
    }
    return found;
}

}  // namespace aoscore
