#include "results/tuning_record.h"

#include "core/files.h"
#include "results/record_json.h"

namespace aoscore {

template <class Visit, RecordOf<SettingsRecord> Record>
void visit_members(Visit& visit, Record& settings) {
    visit("loss", settings.loss);
    visit("fetches", settings.fetches);
    visit("ms", settings.ms);
    visit("loss_by_view", settings.loss_by_view);
}

template <class Visit, RecordOf<HeldOutRecord> Record>
void visit_members(Visit& visit, Record& held_out) {
    visit("left_out", held_out.left_out);
    visit("loss", held_out.loss);
    visit("less_published", held_out.less_published);
    visit("less_published_95", held_out.less_published_95);
    visit("verdict", held_out.verdict);
}

template <class Visit, RecordOf<WorthRecord> Record>
void visit_members(Visit& visit, Record& worth) {
    visit("parameter", worth.parameter);
    visit("published", worth.published);
    visit("tuned", worth.tuned);
    visit("loss_alone", worth.loss_alone);
    visit("loss_without", worth.loss_without);
}

template <class Visit, RecordOf<BudgetRecord> Record>
void visit_members(Visit& visit, Record& budget) {
    visit("most_fetches", budget.most_fetches);
    visit("most_ms", budget.most_ms);
    visit("preset_id", budget.preset_id);
    visit("settings", budget.settings);
    visit("published", budget.published);
    visit("tuned", budget.tuned);
    visit("held_out", budget.held_out);
    visit("worth", budget.worth);
}

template <class Visit, RecordOf<MethodTuningRecord> Record>
void visit_members(Visit& visit, Record& tuning) {
    visit("method", tuning.method);
    visit("label", tuning.label);
    visit("preset", tuning.preset);
    visit("drawn", tuning.drawn);
    visit("reused", tuning.reused);
    visit("budgets", tuning.budgets);
}

template <class Visit, RecordOf<TunedViewRecord> Record>
void visit_members(Visit& visit, Record& view) {
    visit("view", view.view);
    visit("radius_m", view.radius_m);
}

template <class Visit, RecordOf<TuningRecord> Record>
void visit_members(Visit& visit, Record& tuning) {
    visit("program_version", tuning.program_version);
    visit("created_utc", tuning.created_utc);
    visit("command", tuning.command);
    visit("definition", tuning.definition);
    visit("metric", tuning.metric);
    visit("size", tuning.size);
    visit("rays_a_pixel", tuning.rays_a_pixel);
    visit("views", tuning.views);
    visit("methods", tuning.methods);
}

namespace {

constexpr const char* kTuningFile = "tune.json";

/// Checks what the form alone does not say: how many numbers belong together.
void check(const TuningRecord& tuning, const std::string& where) {
    if (tuning.size.size() != 2) throw file_error("has no width and height", where + ".size");
    for (const MethodTuningRecord& method : tuning.methods) {
        for (const BudgetRecord& budget : method.budgets) {
            for (const SettingsRecord* settings : {&budget.published, &budget.tuned}) {
                if (settings->loss_by_view.size() != tuning.views.size())
                    throw file_error("has not one loss for each view", where + ": " + method.method);
            }
            for (const HeldOutRecord& held_out : budget.held_out) {
                if (held_out.less_published_95.size() != 2)
                    throw file_error("has an interval without two ends", where + ": " + method.method);
            }
        }
    }
}

}  // namespace

void write_tuning_record(const TuningRecord& tuning, const std::filesystem::path& folder) {
    nlohmann::json object = record_json::checked_json(tuning, kTuningFile);
    object["schema_version"] = TuningRecord::kSchemaVersion;
    write_atomically(folder / kTuningFile, object.dump(2) + "\n");
}

TuningRecord read_tuning_record(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kTuningFile;
    const nlohmann::json object = parse_json_file(file);
    TuningRecord tuning = record_json::versioned_record_from_json<TuningRecord>(object, file.string());
    check(tuning, file.string());
    return tuning;
}

bool has_tuning_record(const std::filesystem::path& folder) {
    std::error_code ec;
    return std::filesystem::is_regular_file(folder / kTuningFile, ec);
}

std::filesystem::path preset_file_name(const std::string& method) {
    return method + ".tuned.json";
}

}  // namespace aoscore
