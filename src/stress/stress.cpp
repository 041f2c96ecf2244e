#include "stress/stress.h"

#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/known_names.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/progress.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "image/image_file.h"
#include "stress/stress_axes.h"
#include "stress/stress_jobs.h"
#include "stress/stress_judge.h"
#include "stress/stress_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>

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

// The unstressed setting and those at either end, without pictures too large to be traced, which take long.
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

/// Runs settings one after the other.
class StressRun {
  public:
    StressRun(const StressPlan& plan, const std::vector<StressSubject>& subjects, const fs::path& folder)
        : plan_(plan),
          subjects_(subjects),
          folder_(folder),
          store_(ArtifactStore::folder_in(plan.cache)),
          unstressed_(plan, subjects, tools_) {}

    std::string gl_renderer() { return tools_.renderer().renderer(); }

    StressSettingRecord run(const StressAxis& axis, const StressSetting& setting) {
        const Stopwatch watch;
        const std::string key = fmt::format("{}/{}", axis.id, setting.id);
        const StressWork work(plan_, subjects_, stress_case(setting, plan_.size), axis.judgement, key,
                              tools_);
        const StressJobs jobs = stress_jobs(work, unstressed_);
        StressMaker maker(work, store_, unstressed_);
        const Execution done = execute(jobs.graph, maker);
        StressSettingRecord record = maker.setting();
        record.id = setting.id;
        record.label = setting.label;
        record.unstressed = setting.unstressed();
        record.key = jobs.setting.hex;
        record.width = work.stress.width;
        record.height = work.stress.height;
        record.triangles = work.stress.scene.triangle_count;
        record.cells = cells(work, jobs, maker, done);
        record.images = write_thumbnails(jobs, maker, key);
        record.seconds = watch.seconds();
        return record;
    }

  private:
    static std::vector<StressCell> cells(const StressWork& work, const StressJobs& jobs,
                                         const StressMaker& maker, const Execution& done) {
        std::vector<StressCell> cells = work.cells;
        for (std::size_t i = 0; i < jobs.cells.size(); ++i) {
            StressCell& cell = *find_row(cells, work.requests[i].subject->id, &StressCell::subject);
            if (const StressedCell* made = maker.cell(jobs.cells[i])) {
                cell = made->cell;
            } else {
                cell.error = done.failed.at(jobs.cells[i]);
            }
        }
        for (StressCell& cell : cells) judge(work.judgement, cell);
        return cells;
    }

    /// Returns the file's name in the folder; empty where no subject applies.
    std::string write_thumbnails(const StressJobs& jobs, const StressMaker& maker,
                                 const std::string& key) const {
        std::vector<ChannelView> channels;
        for (const Key& job : jobs.cells) {
            const StressedCell* made = maker.cell(job);
            if (made == nullptr) continue;
            channels.push_back({made->cell.subject + ".Y", &made->picture});
            if (!made->difference.empty()) channels.push_back({made->cell.subject + ".D", &made->difference});
        }
        if (channels.empty()) return {};
        const std::string name = fmt::format("settings/{}.exr", key);
        write_exr(folder_ / name, channels, {});
        return name;
    }

    const StressPlan& plan_;
    const std::vector<StressSubject>& subjects_;
    const fs::path& folder_;
    const ArtifactStore store_;
    SceneTools tools_;
    Unstressed unstressed_;
};

}  // namespace

StressResults run_stress(const StressPlan& plan, const fs::path& folder) {
    const Stopwatch watch;
    const std::clock_t start_cpu = std::clock();
    std::vector<std::string> warnings;
    const Registry registry = load_registry(plan.methods_dir, plan.methods, warnings);
    for (const std::string& warning : warnings) log_warning(warning);
    const std::vector<StressSubject> subjects = stress_subjects(registry, plan.methods);
    const std::vector<StressAxis> axes = planned_axes(plan);

    StressResults results = described(plan, subjects);
    StressRun run(plan, subjects, folder);
    results.gl_renderer = run.gl_renderer();
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
            record.settings.push_back(run.run(axis, setting));
            progress.step();
        }
        results.axes.push_back(std::move(record));
    }
    results.total_seconds = watch.seconds();
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
