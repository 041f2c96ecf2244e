#include "results/record_json.h"
#include "results/results_members.h"
#include "results/upgrade/schema_upgrade.h"

#include <fmt/format.h>

namespace aoscore {

using nlohmann::json;
using namespace record_json;

json to_json(const ViewRecord& view) {
    return checked_json(view, view.key);
}

json to_json(const CellRecord& cell) {
    return checked_json(cell, cell.id);
}

ViewRecord view_record_from_json(const json& object, const std::string& where) {
    return record_from_json<ViewRecord>(object, where);
}

CellRecord cell_record_from_json(const json& object, const std::string& where) {
    return record_from_json<CellRecord>(object, where);
}

json to_json(const Results& results) {
    json object = checked_json(results, "results");
    object["schema_version"] = Results::kSchemaVersion;
    return object;
}

json to_json(const ErrorAnalysis& analysis) {
    return checked_json(analysis, "analysis");
}

Results results_from_json(const json& object, const std::string& where) {
    Reader reader{StrictObject::of_file(object, where)};
    int schema_version = 0;
    reader("schema_version", schema_version);
    if (schema_version > Results::kSchemaVersion || schema_version < kOldestSchema) {
        throw file_error(fmt::format("is {}, of {} version of this program", schema_version,
                                     schema_version < kOldestSchema ? "too old a" : "a newer"),
                         reader.object.where("schema_version"),
                         fmt::format("{} to {}", kOldestSchema, Results::kSchemaVersion));
    }
    if (schema_version < Results::kSchemaVersion) {
        json upgraded = object;
        upgrade_schema(upgraded, schema_version);
        upgraded["schema_version"] = Results::kSchemaVersion;
        Results results = results_from_json(upgraded, where);
        results.schema_version = schema_version;
        return results;
    }
    return record_json::versioned_record_from_json<Results>(object, where);
}

}  // namespace aoscore
