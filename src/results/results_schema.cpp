#include "results/results_schema.h"

#include "results/record_schema.h"
#include "results/results_members.h"

namespace aoscore {

nlohmann::json results_schema() {
    nlohmann::json schema = record_json::described<Results>();
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["title"] = "aoscore: results.json";
    schema["description"] =
        "What a run measured; src/results/results.h says what every member means. Paths are relative to the "
        "file's folder, lengths are metres, and null stands for what is not known.";
    schema["properties"]["schema_version"] = {{"const", Results::kSchemaVersion}};
    schema["required"].push_back("schema_version");
    return schema;
}

}  // namespace aoscore
