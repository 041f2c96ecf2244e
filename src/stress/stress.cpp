#include "stress/stress.h"

#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/known_names.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/progress.h"
#include "core/threads.h"
#include "stress/stress_axes.h"
#include "stress/stress_judge.h"
#include "stress/stress_key.h"
#include "stress/stress_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

std::vector<StressAxis> chosen_axes(const StressPlan& plan) {
    for (const std::string& id : plan.axes) row_of(stress_axes(), id, "no stress axis", "--axes");
    std::vector<StressAxis> chosen;
    for (const StressAxis& axis : stress_axes()) {
        if (plan.axes.empty() || std::ranges::find(plan.axes, axis.id) != plan.axes.end())
            chosen.push_back(axis);
    }
    return chosen;
}

// The unstressed setting and those at either end; pictures too large to be traced are no quick test.
std::vector<StressSetting> ends_of(std::vector<StressSetting> settings, int size) {
    while (!stress_case(settings.back(), size).has_truth) settings.pop_back();
    std::vector<StressSetting> ends;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (i == 0 || i + 1 == settings.size() || settings[i].unstressed()) ends.push_back(settings[i]);
    }
    return ends;
}

std::vector<StressAxis> planned_axes(const StressPlan& plan) {
    std::vector<StressAxis> axes = chosen_axes(plan);
    if (plan.ends_only) {
        for (StressAxis& axis : axes) axis.settings = ends_of(axis.settings, plan.size);
    }
    return axes;
}

fs::path setting_file(const fs::path& folder, std::string_view axis, const std::string& setting) {
    return folder / "settings" / axis / (setting + ".json");
}

// What an earlier run has found, when nothing that it depends on has changed.
std::optional<StressSettingRecord> kept_setting(const fs::path& folder, const fs::path& file,
                                                const std::string& key) {
    std::error_code ec;
    if (!fs::is_regular_file(file, ec)) return std::nullopt;
    try {
        StressSettingRecord record = read_stress_setting(file);
        const bool pictured = record.images.empty() || fs::is_regular_file(folder / record.images, ec);
        if (record.key == key && pictured) return record;
    } catch (const Error& e) {
        log_warning(fmt::format("{}: run again", e.what()));
    }
    return std::nullopt;
}

StressResults described(const StressPlan& plan, const std::vector<StressSubject>& subjects) {
    StressResults results;
    results.program_version = version();
    results.created_utc = utc_now();
    results.command = plan.command;
    results.cpu = cpu_name();
    results.threads = thread_count();
    results.seed = plan.seed;
    results.size = plan.size;
    results.samples = plan.samples;
    results.scene = "yard";
    results.filtered_method = kFilteredMethod;
    results.least_compared_pixels = kLeastComparedPixels;
    for (const StressSubject& subject : subjects)
        results.subjects.push_back({subject.id, subject.label, subject.kind, "default", subject.limits()});
    return results;
}

}  // namespace

StressResults run_stress(const StressPlan& plan, const fs::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t start_cpu = std::clock();
    std::vector<std::string> warnings;
    const Registry registry = load_registry(plan.methods_dir, plan.methods, warnings);
    for (const std::string& warning : warnings) log_warning(warning);
    const std::vector<StressSubject> subjects = stress_subjects(registry, plan.methods);
    const std::vector<StressAxis> axes = planned_axes(plan);

    StressResults results = described(plan, subjects);
    StressRunner runner(plan, subjects);
    const StressKeys keys(plan, subjects, runner.renderer());
    results.gl_renderer = runner.renderer().renderer();
    std::size_t total = 0;
    for (const StressAxis& axis : axes) total += axis.settings.size();
    Progress progress("stress", total);
    for (const StressAxis& axis : axes) {
        StressAxisRecord record{std::string(axis.id),
                                std::string(axis.label),
                                std::string(axis.meaning),
                                axis.judgement == StressJudgement::same_picture ? "same picture" : "error",
                                stress_limit(axis.judgement),
                                {}};
        for (const StressSetting& setting : axis.settings) {
            throw_if_interrupted();
            const fs::path file = setting_file(folder, axis.id, setting.id);
            const StressCase stress = stress_case(setting, plan.size);
            const std::string key = keys.of(axis, setting, stress);
            std::optional<StressSettingRecord> done = kept_setting(folder, file, key);
            if (!done) {
                done = runner.run(axis, setting, stress, folder);
                done->key = key;
                write_stress_setting(*done, file);
            }
            record.settings.push_back(std::move(*done));
            progress.step();
        }
        results.axes.push_back(std::move(record));
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    results.total_seconds = elapsed.count();
    results.cpu_seconds = static_cast<double>(std::clock() - start_cpu) / CLOCKS_PER_SEC;
    write_stress_results(results, folder);
    return results;
}

std::size_t failed_cells(const StressResults& results) {
    std::size_t count = 0;
    for (const StressAxisRecord& axis : results.axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            for (const StressCell& cell : setting.cells) count += !cell.error.empty();
        }
    }
    return count;
}

}  // namespace aoscore
