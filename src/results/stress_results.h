#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// What a stress test found: stress.json with its images beside it, the only thing its page is made of.
/// Numbers that could not be had are empty, never NaN.

/// One subject at one setting.
struct StressCell {
    std::string subject;
    std::string skipped;           ///< why it was not run; empty when it was
    std::string error;             ///< why it failed; empty when it did not
    std::size_t nonfinite = 0;     ///< pixels that are NaN or infinite
    std::size_t out_of_range = 0;  ///< finite pixels outside of [0,1]
    std::size_t background = 0;    ///< pixels without surface that are not 1
    /// From the unstressed result: root mean square over the pixels that both have, where exact arithmetic
    /// would give the same picture; else how much the error against the own truth has grown, its noise taken
    /// out; else, without truth, how far the mean moved. Empty where too few pixels can be compared.
    std::optional<double> deviation;
    std::optional<double> rmse;  ///< against the own truth, its noise taken out; axes that change the picture
    std::optional<double> mean;  ///< visibility over the surface
    std::optional<double> time_ms;  ///< one run after another that compiled and warmed up
    std::string breaks;             ///< what is wrong, in words; empty where it holds
};

struct StressSettingRecord {
    std::string id;
    std::string label;
    bool unstressed = false;
    std::string key;  ///< digest of everything that the results depend on
    int width = 0, height = 0;
    std::size_t triangles = 0;
    std::size_t surface_pixels = 0;           ///< in either path
    std::size_t compared_pixels = 0;          ///< the same surface in both
    std::optional<double> disagreeing_share;  ///< of camera-contract pixels away from edges
    int truth_samples = 0;                    ///< rays a pixel; 0 without truth
    double truth_seconds = 0;
    double gbuffer_ms = 0;
    double seconds = 0;  ///< that this run has spent on it
    std::string
        images;  ///< EXR of thumbnails: <subject>.Y and, as deviation is defined, <subject>.D; "" without any
    std::vector<StressCell> cells;
};

struct StressAxisRecord {
    std::string id;
    std::string label;
    std::string meaning;
    std::string judgement;  ///< "same picture" or "error"
    double limit = 0;       ///< a deviation beyond it breaks
    std::vector<StressSettingRecord> settings;
};

struct StressSubjectRecord {
    std::string id;
    std::string label;
    std::string kind;  ///< "method", "filter", "reference", "bound"
    std::string preset;
    std::map<std::string, std::string> limits;  ///< axis -> why it breaks there by its nature
};

struct StressResults {
    static constexpr int kSchemaVersion = 1;
    std::string program_version;
    std::string created_utc;
    std::string command;
    std::string cpu;
    int threads = 0;
    std::string gl_renderer;
    std::uint64_t seed = 0;
    int size = 0;     ///< of the base picture, pixels a side
    int samples = 0;  ///< rays a pixel of the truths
    std::string scene;
    std::string filtered_method;            ///< whose output the filters are given
    std::size_t least_compared_pixels = 0;  ///< fewer are not judged by deviation
    double total_seconds = 0;  ///< wall clock of the last run; settings that were there already not counted
    double cpu_seconds = 0;    ///< the same, over all threads
    std::vector<StressSubjectRecord> subjects;
    std::vector<StressAxisRecord> axes;
};

/// Where one subject breaks on one axis, walking from the unstressed setting in either direction.
struct StressBreak {
    const StressSettingRecord* setting = nullptr;
    const StressCell* cell = nullptr;
};
/// The first setting on either side that breaks: none, one or two.
std::vector<StressBreak> first_breaks(const StressAxisRecord& axis, const std::string& subject);

/// folder/stress.json. Reading throws file_error for what is missing, of another version or not understood.
void write_stress_results(const StressResults& results, const std::filesystem::path& folder);
StressResults read_stress_results(const std::filesystem::path& folder);
/// Whether a folder holds a stress test's results.
bool has_stress_results(const std::filesystem::path& folder);

// What is kept of a setting and of a cell, so that an interrupted run goes on where it was. Reading throws
// file_error for another form.
nlohmann::json to_json(const StressSettingRecord& setting);
StressSettingRecord stress_setting_from_json(const nlohmann::json& json, const std::string& where);
nlohmann::json to_json(const StressCell& cell);
StressCell stress_cell_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
