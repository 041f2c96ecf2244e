#pragma once

#include <nlohmann/json.hpp>

namespace aoscore {

/// The oldest schema of results.json that can still be read. Earlier ones were never released: 1 has no sums
/// of blocks, from which ranks follow, 2 none of SSIM and FLIP, and 3 no places for the times of a frame.
inline constexpr int kOldestSchema = 4;

/// Brings the contents of a results.json of an older schema, kOldestSchema at least, to that of
/// Results::kSchemaVersion, step by step. What the file does not say becomes empty, and a warning in the
/// results names it. Rankings of schema 4 are left out: they ranked each preset apart (see ranked_anew()).
/// Members of another form stay as they are, for the strict reader to refuse.
void upgrade_schema(nlohmann::json& results, int schema_version);

}  // namespace aoscore
