#include "jobs/job.h"

#include <algorithm>
#include <utility>

namespace aoscore {

const Job& JobGraph::add(Job job) {
    const auto [found, is_new] = index_.emplace(job.key, jobs_.size());
    if (is_new) jobs_.push_back(std::move(job));
    return jobs_[found->second];
}

const Job& JobGraph::want(Job job) {
    const Job& added = add(std::move(job));
    if (std::find(wanted_.begin(), wanted_.end(), added.key) == wanted_.end()) wanted_.push_back(added.key);
    return added;
}

}  // namespace aoscore
