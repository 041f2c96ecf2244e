#pragma once

#include "core/parameter_value.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The results of a tuning, from which alone its page is made: tune.json, with the presets that were found
/// beside it. A loss is how far the metric is from its best value; missing numbers are empty, never NaN.

/// Settings on the views that were tuned on.
struct SettingsRecord {
    double loss = 0;           ///< over all views
    double fetches = 0;        ///< a pixel
    std::optional<double> ms;  ///< empty where the budget does not limit them
    std::vector<double> loss_by_view;
};

/// What tuning is worth on views that were left out, each group once.
struct HeldOutRecord {
    std::string left_out;                   ///< "view" or "scene"
    double loss = 0;                        ///< over the views that were left out
    double less_published = 0;              ///< loss less that of the preset begun from, the mean over groups
    std::vector<double> less_published_95;  ///< the interval of that: low, high
    std::string verdict;                    ///< "closer", "tie" or "farther"
};

struct WorthRecord {
    std::string parameter;
    double published = 0, tuned = 0;  ///< values at the preset's own AO radius
    double loss_alone = 0;            ///< with this one tuned and the others published
    double loss_without = 0;          ///< with this one published and the others tuned
};

/// The settings of least loss within one budget.
struct BudgetRecord {
    std::optional<double> most_fetches, most_ms;
    std::string preset_id;  ///< what the preset is called in the file of presets
    ParameterValues settings;
    SettingsRecord published, tuned;
    std::vector<HeldOutRecord> held_out;  ///< by views, then by scenes; empty where one view is all there is
    std::vector<WorthRecord> worth;
};

struct MethodTuningRecord {
    std::string method, label;
    std::string preset;                 ///< the one that tuning began from
    std::size_t drawn = 0, reused = 0;  ///< images drawn, and those that were measured before
    std::vector<BudgetRecord> budgets;
};

struct TunedViewRecord {
    std::string view;  ///< "atrium/wide"
    double radius_m = 0;
};

struct TuningRecord {
    static constexpr int kSchemaVersion = 2;
    std::string program_version;
    std::string created_utc;
    std::string command;
    std::string definition;  ///< id of the file in reports/tunings/; empty: the command says all
    std::string metric;
    std::vector<int> size;  ///< width, height
    int rays_a_pixel = 0;
    std::vector<TunedViewRecord> views;
    std::vector<MethodTuningRecord> methods;
};

/// Writes folder/tune.json.
void write_tuning_record(const TuningRecord& tuning, const std::filesystem::path& folder);
/// Reads it. Throws file_error for another form or schema version.
TuningRecord read_tuning_record(const std::filesystem::path& folder);
/// Whether a folder holds one.
bool has_tuning_record(const std::filesystem::path& folder);

/// The file of a method's presets beside tune.json, which --preset takes.
std::filesystem::path preset_file_name(const std::string& method);

}  // namespace aoscore
