#include "results/record_json.h"
#include "results/results_members.h"

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
    return record_json::versioned_record_from_json<Results>(object, where);
}

}  // namespace aoscore
