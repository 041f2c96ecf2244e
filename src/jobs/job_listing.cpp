#include "jobs/job_listing.h"

#include "core/error.h"
#include "core/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace aoscore {
namespace {

std::string description_key(const std::string& job) {
    return Digest().text("job").text(job).hex();
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

JobGraph only(const JobGraph& graph, const Key& key) {
    JobGraph part;
    for (const Job& job : graph.jobs()) {
        if (job.key == key) {
            part.want(job);
        } else {
            part.add(job);
        }
    }
    return part;
}

}  // namespace

void JobListing::add(const JobGraph& graph) {
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
             {"known", has_entry(job.kind) ? nlohmann::json(store_.has(job.key.hex)) : nlohmann::json()}});
        store_.put(description_key(job.key.hex), {{"arguments", arguments_}});
    }
}

std::vector<std::string> arguments_of_job(const std::string& key, const std::filesystem::path& cache) {
    const std::optional<nlohmann::json> found =
        ArtifactStore(ArtifactStore::folder_in(cache)).find(description_key(key));
    if (!found) {
        throw usage_error("no command has listed the job " + key, "KEY",
                          "a key that --jobs has printed, with the same cache");
    }
    return found->at("arguments").get<std::vector<std::string>>();
}

bool has_job_to_make(const JobGraph& graph, const std::string& key, const ArtifactStore& store) {
    if (!store.enabled())
        throw usage_error("a single job needs a store to put its artifact in", "--no-cache");
    if (!graph.contains({key})) return false;
    const ArtifactKind kind = graph.at({key}).kind;
    if (!is_kept(kind)) {
        throw usage_error(fmt::format("a {} is not kept: it is made wherever it is needed", id_of(kind)), key,
                          "the key of another kind of job");
    }
    return true;
}

void make_alone(const JobGraph& graph, const std::string& key, Maker& maker) {
    const Job& job = graph.at({key});
    const Execution done = execute(only(graph, job.key), maker);
    if (done.has_failed(job.key)) throw internal_error(done.failed.at(job.key), job.about);
    log_info(
        fmt::format("{} of {}: {}", id_of(job.kind), job.about, done.taken.empty() ? "made" : "was there"));
}

void throw_no_such_job(const std::string& key) {
    throw usage_error("the command has no job " + key, "KEY", "a key that --jobs prints for it");
}

}  // namespace aoscore
