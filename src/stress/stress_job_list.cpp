#include "stress/stress_job_list.h"

#include "jobs/job_listing.h"
#include "stress/stress_maker.h"
#include "stress/stress_schedule.h"

namespace aoscore {

nlohmann::json list_stress_jobs(const StressPlan& plan, const std::vector<std::string>& arguments) {
    StressSchedule schedule(plan);
    JobListing listing(schedule.store(), arguments);
    // Stressed views are alike in size and rays.
    const auto even = [](const Job&) { return 1.0; };
    for (const StressAxis& axis : schedule.axes()) {
        for (const StressSetting& setting : axis.settings)
            listing.add(stress_jobs(schedule.work_of(axis, setting), schedule.unstressed()).graph, even);
    }
    return listing.json();
}

std::size_t make_stress_jobs(const StressPlan& plan, const std::vector<std::string>& keys) {
    StressSchedule schedule(plan);
    ChosenJobs chosen(keys, schedule.store());
    for (const StressAxis& axis : schedule.axes()) {
        for (const StressSetting& setting : axis.settings) {
            const StressWork work = schedule.work_of(axis, setting);
            const StressJobs jobs = stress_jobs(work, schedule.unstressed());
            if (!chosen.any_in(jobs.graph)) continue;
            StressMaker maker(work, schedule.store(), schedule.unstressed());
            chosen.make(jobs.graph, maker);
        }
    }
    return chosen.failed();
}

}  // namespace aoscore
