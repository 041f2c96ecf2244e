#include "stress/stress.h"

#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/known_names.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/node_kind.h"
#include "core/progress.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "image/image_file.h"
#include "stress/stress_judge.h"
#include "stress/stress_maker.h"
#include "stress/stress_schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

StressResults described(const StressPlan& plan, const std::vector<StressSubject>& subjects) {
    StressResults results;
    results.program_version = version();
    results.created_utc = utc_now();
    results.command = plan.command;
    results.cpu = machine_name();
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
    StressRun(StressSchedule& schedule, const fs::path& folder) : schedule_(schedule), folder_(folder) {}

    StressSettingRecord run(const StressAxis& axis, const StressSetting& setting) {
        const Stopwatch watch;
        const StressWork work = schedule_.work_of(axis, setting);
        const StressJobs jobs = stress_jobs(work, schedule_.unstressed());
        StressMaker maker(work, schedule_.store(), schedule_.unstressed());
        ExecutionOptions options;
        options.times = takes_times();
        const Execution done = execute(jobs.graph, maker, options);
        times_left_out_ += done.left_out.size();
        StressSettingRecord record = maker.setting();
        record.gbuffer_ms = maker.time_ms(jobs.gbuffer_times).value_or(0);
        record.id = setting.id;
        record.label = setting.label;
        record.unstressed = setting.unstressed();
        record.key = jobs.setting.hex;
        record.width = work.stress.width;
        record.height = work.stress.height;
        record.triangles = work.stress.scene.triangle_count;
        record.cells = cells(work, jobs, maker, done);
        record.images = write_thumbnails(jobs, maker, StressSchedule::key_of(axis, setting));
        record.seconds = watch.seconds();
        return record;
    }

    std::size_t times_left_out() const { return times_left_out_; }

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
            const std::optional<Key>& times = jobs.times[i];
            if (!times) continue;
            cell.time_ms = maker.time_ms(*times);
            if (done.has_failed(*times)) cell.error = done.failed.at(*times);
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

    StressSchedule& schedule_;
    const fs::path& folder_;
    std::size_t times_left_out_ = 0;
};

}  // namespace

StressResults run_stress(const StressPlan& plan, const fs::path& folder) {
    const Stopwatch watch;
    const std::clock_t start_cpu = std::clock();
    StressSchedule schedule(plan);
    StressResults results = described(plan, schedule.subjects());
    results.gl_renderer = schedule.tools().renderer().renderer();
    StressRun run(schedule, folder);
    Progress progress("stress", schedule.setting_count());
    for (const StressAxis& axis : schedule.axes()) {
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
    if (run.times_left_out() > 0) log_warning(times_left_out_text(run.times_left_out()));
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
