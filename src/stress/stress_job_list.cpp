#include "stress/stress_job_list.h"

#include "jobs/job_listing.h"
#include "stress/stress_maker.h"
#include "stress/stress_schedule.h"

namespace aoscore {

nlohmann::json list_stress_jobs(const StressPlan& plan, const std::vector<std::string>& arguments) {
    StressSchedule schedule(plan);
    JobListing listing(schedule.store(), arguments);
    for (const StressAxis& axis : schedule.axes()) {
        for (const StressSetting& setting : axis.settings)
            listing.add(stress_jobs(schedule.work_of(axis, setting), schedule.unstressed()).graph);
    }
    return listing.json();
}

void make_stress_job(const StressPlan& plan, const std::string& key) {
    StressSchedule schedule(plan);
    for (const StressAxis& axis : schedule.axes()) {
        for (const StressSetting& setting : axis.settings) {
            const StressWork work = schedule.work_of(axis, setting);
            const StressJobs jobs = stress_jobs(work, schedule.unstressed());
            if (!has_job_to_make(jobs.graph, key, schedule.store())) continue;
            StressMaker maker(work, schedule.store(), schedule.unstressed());
            return make_alone(jobs.graph, key, maker);
        }
    }
    throw_no_such_job(key);
}

}  // namespace aoscore
