#include "results/upgrade/schema_upgrade.h"

#include "results/results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

/// A member that came with a schema: the value stands for "unknown" in results that lack it.
struct NewMember {
    const char* name;
    json unknown;
};

/// Whether any of them was missing.
bool add_members(json& object, const std::vector<NewMember>& members) {
    bool missing = false;
    for (const NewMember& member : members) {
        if (object.contains(member.name)) continue;
        object[member.name] = member.unknown;
        missing = true;
    }
    return missing;
}

/// Renames a member, unless the new name is taken.
void rename_member(json& object, const char* from, const char* to) {
    if (!object.contains(from)) return;
    if (!object.contains(to)) object[to] = std::move(object[from]);
    object.erase(from);
}

/// Calls `change` for each object in the array of that name, if it is one.
template <class Change>
void for_each_object(json& object, const char* array, Change change) {
    if (!object.contains(array) || !object[array].is_array()) return;
    for (json& element : object[array]) {
        if (element.is_object()) change(element);
    }
}

/// Calls `change` for the member of that name, if it is an object.
template <class Change>
void for_object(json& object, const char* name, Change change) {
    if (object.contains(name) && object[name].is_object()) change(object[name]);
}

json no_runs() {
    return {{"runs_ms", json::array()}, {"median_ms", json()}, {"spread_ms", json()}};
}

/// What results do not say though they may have it, in words.
using Unsaid = std::set<std::string>;

void from_4(json& results, Unsaid& unsaid) {
    for_each_object(results, "cells", [](json& cell) {
        add_members(cell, {{"role", kMethodRole}});
        for_object(cell, "analysis", [](json& analysis) {
            add_members(analysis, {{"tile_pattern", json()}});
        });
    });
    for_each_object(results, "views", [](json& view) {
        for_object(view, "savings", [](json& savings) { add_members(savings, {{"left_out_triangles", 0}}); });
    });
    results["rankings"] = json::array();
    unsaid.insert("which methods are bounds (all are ranked)");
}

void from_5(json& results, Unsaid& unsaid) {
    for_each_object(results, "views", [](json& view) {
        add_members(
            view, {{"radius_rule", ""}, {"halves", false}, {"score_error", json()}, {"final_answer", true}});
        if (view.contains("integrator") && view["integrator"].is_number_integer())
            view["integrator"] = view["integrator"].dump();
    });
    for_each_object(results, "cells", [&](json& cell) {
        if (add_members(cell, {{"lengths", json::array()}}))
            unsaid.insert("the lengths that methods were drawn with");
        for_object(cell, "analysis", [](json& analysis) {
            add_members(analysis, {{"truth_noise", json::object()}});
        });
    });
}

/// Every truth of a view had the view's rays.
void from_6(json& results, Unsaid&) {
    for_each_object(results, "views", [](json& view) {
        add_members(view, {{"signals", json::array()}});
        const json samples = view.value("samples", json());
        for_each_object(view, "truths", [&](json& truth) { add_members(truth, {{"samples", samples}}); });
    });
    for_each_object(results, "cells", [](json& cell) {
        rename_member(cell, "blur", "filter_pass");
        add_members(cell, {{"signals", json::object()}});
    });
}

void from_7(json& results, Unsaid&) {
    for_each_object(results, "cells", [](json& cell) {
        add_members(cell, {{"layers_processor", no_runs()}, {"repeats", json()}});
    });
}

void add_found_parts(json& found) {
    add_members(found, {{"parts", json::array()}, {"squared_parts", json::array()}});
}

/// The fixed pass had its median alone.
void add_fixed_pass(json& cell) {
    json fixed_pass = no_runs();
    fixed_pass["median_ms"] = cell.value("fixed_pass_ms", json());
    add_members(cell, {{"fixed_pass", fixed_pass}});
    cell.erase("fixed_pass_ms");
}

void from_8(json& results, Unsaid& unsaid) {
    const auto with_processor_time = [](json& timing) {
        add_members(timing, {{"processor_runs_ms", json::array()}});
    };
    for_each_object(results, "views", [&](json& view) { for_object(view, "gbuffer", with_processor_time); });
    for_each_object(results, "cells", [&](json& cell) {
        if (add_members(cell, {{"gbuffer", no_runs()}, {"gbuffer_bytes", json()}}))
            unsaid.insert("the size of G-buffers");
        add_fixed_pass(cell);
        cell.erase("ao_processor");
        for (const char* timing : {"ao", "filter_pass", "layers_processor", "fixed_pass", "lighting",
                                   "gbuffer", "frame_at_once", "frame_by_pass"})
            for_object(cell, timing, with_processor_time);
        for_object(cell, "analysis", [](json& analysis) {
            add_members(analysis, {{"found_beyond_layer", json()}});
            for_object(analysis, "fit", [](json& fit) {
                add_members(fit, {{"squared_sums", json::array()}});
            });
        });
        for_object(cell, "repeats", [](json& repeats) {
            add_members(repeats,
                        {{"of_grazing", json()}, {"raw_from_converged", json()}, {"from_converged", json()}});
            for (const char* found : {"of_truth", "of_layers", "of_grazing"})
                for_object(repeats, found, add_found_parts);
        });
        add_members(cell, {{"light", json::object()}});
    });
    add_members(results, {{"advice", json::array()}});
    unsaid.insert("processor times");
    unsaid.insert("single runs of the pass that fetches are related to");
}

void from_9(json& results, Unsaid& unsaid) {
    for_each_object(results, "cells", [&](json& cell) {
        if (add_members(cell, {{"layer_bytes", json()}})) unsaid.insert("the size of depth layers");
        for_object(cell, "analysis", [](json& analysis) {
            add_members(analysis,
                        {{"behind_edges", {{"counts", json::array()}, {"signed_sums", json::array()}}}});
        });
        for_object(cell, "repeats", [](json& repeats) {
            add_members(repeats, {{"hidden_angles", json::object()}, {"other_angles", json::object()}});
        });
    });
}

/// Light was measured for claims alone, and its irradiance not kept.
void from_10(json& results, Unsaid& unsaid) {
    for_each_object(results, "views", [&](json& view) {
        if (add_members(view, {{"light", json()}})) unsaid.insert("the light of an environment");
    });
    for_each_object(results, "cells", [](json& cell) { add_members(cell, {{"lit_file", ""}}); });
}

/// A step from one schema to the next. A member is added by the step from the last schema whose files may
/// lack it: several came while a number was in use.
struct SchemaUpgrade {
    int from;
    void (*apply)(json& results, Unsaid& unsaid);
};

constexpr SchemaUpgrade kUpgrades[] = {{4, from_4}, {5, from_5}, {6, from_6},  {7, from_7},
                                       {8, from_8}, {9, from_9}, {10, from_10}};
static_assert(std::size(kUpgrades) == Results::kSchemaVersion - kOldestSchema);

std::string warning_of(const Unsaid& unsaid, const json& results, int schema_version) {
    const json written_by = results.value("program_version", json(""));
    return fmt::format("These results are of schema {}, written by aoscore {}. They do not say: {}.",
                       schema_version, written_by.is_string() ? written_by.get<std::string>() : "",
                       fmt::join(unsaid, "; "));
}

}  // namespace

void upgrade_schema(json& results, int schema_version) {
    Unsaid unsaid;
    for (const SchemaUpgrade& upgrade : kUpgrades) {
        if (upgrade.from >= schema_version) upgrade.apply(results, unsaid);
    }
    if (results.contains("warnings") && results["warnings"].is_array())
        results["warnings"].push_back(warning_of(unsaid, results, schema_version));
}

}  // namespace aoscore
