#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The results of a stress test, from which alone its page is made: stress.json with images beside it.
/// Missing numbers are empty, never NaN.

/// One subject at one setting.
struct StressCell {
    std::string subject;
    std::string skipped;           ///< why it was not run; else empty
    std::string error;             ///< why it failed; else empty
    std::size_t nonfinite = 0;     ///< pixels that are NaN or infinite
    std::size_t out_of_range = 0;  ///< finite pixels outside of [0,1]
    std::size_t background = 0;    ///< pixels without surface that are not 1
    /// The deviation from the unstressed result: the root mean square over common pixels, where exact
    /// arithmetic would give the same picture; else the increase of the debiased error against the own truth;
    /// else, without truth, the change of the mean. Empty where too few pixels can be compared.
    std::optional<double> deviation;
    std::optional<double> rmse;     ///< debiased, against the own truth; on axes that change the picture
    std::optional<double> mean;     ///< mean visibility over the surface
    std::optional<double> time_ms;  ///< one run, after another that compiled and warmed up
    std::string breaks;             ///< the fault in words; empty where it holds
};

struct StressSettingRecord {
    std::string id;
    std::string label;
    bool unstressed = false;
    std::string key;  ///< digest of all that the results depend on
    int width = 0, height = 0;
    std::size_t triangles = 0;
    std::size_t surface_pixels = 0;           ///< pixels with surface in either path
    std::size_t compared_pixels = 0;          ///< pixels with the same surface in both
    std::optional<double> disagreeing_share;  ///< share of camera-contract pixels away from edges
    int truth_samples = 0;                    ///< rays a pixel; 0 without truth
    double truth_seconds = 0;
    double gbuffer_ms = 0;
    double seconds = 0;  ///< time that this run has spent on it
    std::string images;  ///< EXR of thumbnails: <subject>.Y and, where deviation has a difference,
                         ///< <subject>.D; "" without any
    std::vector<StressCell> cells;
};

struct StressAxisRecord {
    std::string id;
    std::string label;
    std::string meaning;
    std::string judgement;  ///< "same picture" or "error"
    double limit = 0;       ///< a larger deviation breaks
    std::vector<StressSettingRecord> settings;
};

struct StressSubjectRecord {
    std::string id;
    std::string label;
    std::string kind;  ///< "method", "filter", "reference", "bound"
    std::string preset;
    std::map<std::string, std::string> limits;  ///< by axis, why it breaks there by its nature
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
    int size = 0;     ///< side of the base picture in pixels
    int samples = 0;  ///< rays a pixel of the truths
    std::string scene;
    std::string filtered_method;            ///< the method whose output is filtered
    std::size_t least_compared_pixels = 0;  ///< with fewer, no deviation is judged
    double total_seconds = 0;  ///< wall clock of the last run, without settings taken from the cache
    double cpu_seconds = 0;    ///< processor time of all threads, counted alike
    std::vector<StressSubjectRecord> subjects;
    std::vector<StressAxisRecord> axes;
};

/// The first setting at which a subject breaks on one axis, in one direction from the unstressed setting.
struct StressBreak {
    const StressSettingRecord* setting = nullptr;
    const StressCell* cell = nullptr;
};
/// The first setting on either side that breaks: none, one or two.
std::vector<StressBreak> first_breaks(const StressAxisRecord& axis, const std::string& subject);

/// Write and read folder/stress.json. Reading throws file_error for a file that is missing, of another
/// version or not understood.
void write_stress_results(const StressResults& results, const std::filesystem::path& folder);
StressResults read_stress_results(const std::filesystem::path& folder);
/// Whether a folder holds a stress test's results.
bool has_stress_results(const std::filesystem::path& folder);

// Write and read one setting and one cell, for artifacts by which an interrupted run goes on. Reading throws
// file_error for another form.
nlohmann::json to_json(const StressSettingRecord& setting);
StressSettingRecord stress_setting_from_json(const nlohmann::json& json, const std::string& where);
nlohmann::json to_json(const StressCell& cell);
StressCell stress_cell_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
