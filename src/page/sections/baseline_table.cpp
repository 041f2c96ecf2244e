#include "page/sections/baseline_table.h"

#include "page/document/number_text.h"
#include "results/baseline_scope.h"

#include <fmt/format.h>

namespace aoscore {

nlohmann::json baseline_tables(const Results& results) {
    using nlohmann::json;
    json tables = json::array();
    if (!results.baseline) return tables;
    json rows = json::array();
    for (const ChangeRecord& change : results.baseline->changes) {
        const CellRecord* cell = find_cell(results, change.cell_id);
        rows.push_back({{"view", cell != nullptr ? cell->view_key : ""},
                        {"method", cell != nullptr ? shown_name(*cell) : change.cell_id},
                        {"preset", cell != nullptr ? cell->preset : ""},
                        {"before", fixed_text(change.before, 4)},
                        {"now", fixed_text(change.now, 4)},
                        {"change", change.change ? fmt::format("{} to {}", fixed_text(change.change->low, 4),
                                                               fixed_text(change.change->high, 4))
                                                 : std::string(kNoNumber)},
                        {"verdict", change.verdict},
                        {"worse", change.verdict == "worse"},
                        {"reason", change.reason}});
    }
    tables.push_back({{"command", results.baseline->command},
                      {"created", results.baseline->created_utc},
                      {"version", results.baseline->program_version},
                      {"scope", baseline_scope(results)},
                      {"rows", std::move(rows)}});
    return tables;
}

}  // namespace aoscore
