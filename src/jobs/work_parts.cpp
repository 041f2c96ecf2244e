#include "jobs/work_parts.h"

#include "core/error.h"
#include "core/files.h"
#include "core/strict_json.h"
#include "jobs/job.h"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace aoscore {
namespace {

/// Jobs that one process should make.
struct Unit {
    double cost_s = 0;
    std::vector<std::string> keys;
};

/// The units in the order of the listing, without those that have nothing to make.
std::vector<Unit> units_of(const nlohmann::json& listing) {
    std::vector<Unit> units;
    std::map<std::string, std::size_t> index;
    for (const nlohmann::json& job : listing.at("jobs")) {
        if (job.at("known") == true) continue;
        const auto [found, is_new] = index.try_emplace(job.at("unit").get<std::string>(), units.size());
        if (is_new) units.emplace_back();
        Unit& unit = units[found->second];
        unit.cost_s += job.at("cost_s").get<double>();
        if (job.at("asked") == true) unit.keys.push_back(job.at("key"));
    }
    std::erase_if(units, [](const Unit& unit) { return unit.keys.empty(); });
    return units;
}

/// The keys of truths that somebody has to trace, or find in the cache.
std::vector<std::string> truth_keys(const nlohmann::json& listing) {
    std::vector<std::string> keys;
    for (const nlohmann::json& job : listing.at("jobs")) {
        const std::string kind = job.at("kind");
        if (kind == id_of(ArtifactKind::truth) || kind == id_of(ArtifactKind::own_truth))
            keys.push_back(job.at("key"));
    }
    return keys;
}

/// Adds parts that only help to trace the truths, in turn, up to `count` parts.
void add_helpers(const nlohmann::json& listing, std::size_t count, std::vector<WorkPart>& parts) {
    const std::vector<std::string> truths = truth_keys(listing);
    if (parts.empty() || truths.empty()) return;
    for (std::size_t i = 0; parts.size() < count; ++i) parts.push_back({0, {truths[i % truths.size()]}});
}

}  // namespace

std::vector<WorkPart> even_parts(const nlohmann::json& listing, std::size_t count) {
    const std::vector<Unit> units = units_of(listing);
    double left_s = 0;
    for (const Unit& unit : units) left_s += unit.cost_s;
    std::vector<WorkPart> parts;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const Unit& unit = units[i];
        const std::size_t parts_left = count - parts.size(), units_left = units.size() - i;
        // Begins another part where this one has its share of what is left, or every unit left needs a part
        // of its own.
        const bool full =
            !parts.empty() && parts_left > 0 &&
            (parts.back().cost_s + unit.cost_s / 2 > (left_s + parts.back().cost_s) / (parts_left + 1) ||
             units_left <= parts_left);
        if (parts.empty() || full) parts.emplace_back();
        parts.back().cost_s += unit.cost_s;
        parts.back().keys.insert(parts.back().keys.end(), unit.keys.begin(), unit.keys.end());
        left_s -= unit.cost_s;
    }
    add_helpers(listing, count, parts);
    return parts;
}

void write_parts(const WorkParts& work, const std::filesystem::path& file) {
    nlohmann::json parts = nlohmann::json::array();
    for (const WorkPart& part : work.parts) parts.push_back({{"cost_s", part.cost_s}, {"jobs", part.keys}});
    const nlohmann::json json{{"aoscore", version()},
                              {"command", work.command.json()},
                              {"times_on", work.times_on},
                              {"parts", parts}};
    write_atomically(file, json.dump(1) + "\n");
}

WorkParts read_parts(const std::filesystem::path& file) {
    const nlohmann::json json = parse_json_file(file);
    StrictObject root = StrictObject::of_file(json, file.string());
    if (const std::string made_by = root.text("aoscore"); made_by != version())
        throw file_error(fmt::format("was written by version {}, this is {}", made_by, version()),
                         root.where("aoscore"), "a plan of this version: make it again");
    WorkParts work{.command = PlannedCommand::of_json(root.raw("command"), root.where("command")),
                   .times_on = root.text("times_on"),
                   .parts = {}};
    for (StrictObject& object : root.objects("parts")) {
        work.parts.push_back(
            {object.number("cost_s", 0, std::numeric_limits<double>::max()), object.texts_or_empty("jobs")});
        object.finish();
    }
    root.finish();
    return work;
}

}  // namespace aoscore
