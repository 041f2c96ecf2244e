#include "jobs/job_listing.h"

#include "core/error.h"
#include "core/log.h"
#include "core/node_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace aoscore {
namespace {

std::string description_key(const std::string& job) {
    return Digest().text("job by name").text(job).hex();
}

std::string name_of(const Job& job) {
    return fmt::format("{} of {}", id_of(job.kind), job.about);
}

/// What the store keeps of a job beside its artifact: "command", of PlannedCommand::json(), and "name".
std::optional<nlohmann::json> description_of(const std::string& key, const ArtifactStore& store) {
    return store.find(description_key(key));
}

nlohmann::json hex_of(const std::vector<Key>& keys) {
    nlohmann::json list = nlohmann::json::array();
    for (const Key& key : keys) list.push_back(key.hex);
    return list;
}

bool is_kept(ArtifactKind kind) {
    return kind != ArtifactKind::gbuffer && kind != ArtifactKind::contract &&
           kind != ArtifactKind::unstressed;
}

/// Whether it lies in the store under its key; truths lie there by the tile.
bool has_entry(ArtifactKind kind) {
    return is_kept(kind) && kind != ArtifactKind::truth && kind != ArtifactKind::own_truth;
}

JobGraph only(const JobGraph& graph, const std::set<std::string>& keys) {
    JobGraph part;
    for (const Job& job : graph.jobs()) {
        if (keys.contains(job.key.hex)) {
            part.want(job);
        } else {
            part.add(job);
        }
    }
    return part;
}

}  // namespace

void JobListing::add(const JobGraph& graph, const std::function<double(const Job&)>& cost_s) {
    const std::size_t number = graphs_++;
    const auto wanted = graph.wanted();
    for (const Job& job : graph.jobs()) {
        if (!listed_.insert(job.key).second) continue;
        jobs_.push_back(
            {{"key", job.key.hex},
             {"kind", id_of(job.kind)},
             {"about", job.about},
             {"inputs", hex_of(job.inputs)},
             {"after", hex_of(job.after)},
             {"asked", std::ranges::find(wanted, job.key) != wanted.end()},
             {"known", has_entry(job.kind) ? nlohmann::json(store_.has(job.key.hex)) : nlohmann::json()},
             {"unit", fmt::format("{}: {}", number, job.in_turns ? "times" : job.about)},
             {"cost_s", cost_s(job)}});
        store_.put(description_key(job.key.hex), {{"command", command_}, {"name", name_of(job)}});
    }
}

PlannedCommand command_of_job(const std::string& key, const std::filesystem::path& cache) {
    const auto found = description_of(key, ArtifactStore(ArtifactStore::folder_in(cache)));
    if (!found) {
        throw usage_error("no command has listed this job", key,
                          "a key that --jobs has printed, with the same cache");
    }
    return PlannedCommand::of_json(found->at("command"), "the job " + key);
}

ChosenJobs::ChosenJobs(const std::vector<std::string>& keys, const ArtifactStore& store)
    : store_(store), left_(keys.begin(), keys.end()) {
    if (!store.enabled())
        throw usage_error("single jobs need a store to put their artifacts in", "--no-cache");
}

bool ChosenJobs::any_in(const JobGraph& graph) const {
    bool any = false;
    for (const std::string& key : left_) {
        if (!graph.contains({key})) continue;
        if (const ArtifactKind kind = graph.at({key}).kind; !is_kept(kind)) {
            throw usage_error(fmt::format("a {} is not kept: it is made wherever it is needed", id_of(kind)),
                              key, "the key of another kind of job");
        }
        any = true;
    }
    return any;
}

void ChosenJobs::make(const JobGraph& graph, Maker& maker) {
    const JobGraph part = only(graph, left_);
    const auto known = [&](const Key& key) { return store_.has(key.hex); };
    if (!std::ranges::all_of(part.wanted(), known)) store_.require_writable();
    ExecutionOptions options;
    options.times = takes_times();
    const Execution done = execute(part, maker, options);
    if (!done.left_out.empty()) log_info(times_left_out_text(done.left_out.size()));
    for (const Key& key : part.wanted()) {
        const Job& job = part.at(key);
        left_.erase(key.hex);
        if (done.has_failed(key)) {
            ++failed_;
            log_warning(fmt::format("{} failed: {}", name_of(job), done.failed.at(key)));
            continue;
        }
        if (std::ranges::find(done.left_out, key) != done.left_out.end()) continue;
        const bool was_there = std::ranges::find(done.taken, key) != done.taken.end();
        log_info(fmt::format("{}: {}", name_of(job), was_there ? "was there" : "made"));
    }
}

std::size_t ChosenJobs::failed() const {
    if (!left_.empty()) {
        const std::string& key = *left_.begin();
        const auto listed = description_of(key, store_);
        if (!listed)
            throw usage_error("the command has no such job, and this cache has none of this key", key,
                              "a key that --jobs prints for it, or a plan's with the cache of the plan");
        throw file_error(
            "is no job of the command any more: another build listed it, or a file that it reads "
            "has changed since",
            fmt::format("{} ({})", listed->at("name").get<std::string>(), key),
            "a key that --jobs prints now; where a plan names it, make the plan again");
    }
    if (store_.lost_some())
        throw file_error("does not keep all that was made, and nothing else was to be done",
                         store_.folder().string(), "a cache that can be written");
    return failed_;
}

}  // namespace aoscore
