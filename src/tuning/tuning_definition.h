#pragma once

#include "plan/resolved_cell.h"
#include "tuning/tuning_run.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// The file of a tuning's definition: reports/tunings/<name>.json, or `name` itself where it is a path that
/// ends in .json. Throws usage_error, which lists the known ones, for another name.
std::filesystem::path tuning_definition_file(const std::string& name);

/// Reads what a definition says into the plan: scenes with their views, methods with the preset to begin from
/// and the parameters of each, metric, effort, size and rays. Of its methods only `methods` are taken, all
/// where that is empty. Scenes that the program does not generate are files of `scenes_dir`. Throws
/// file_error for another form and an unknown method; usage_error, first for one of `methods` that the
/// definition does not tune, then for a scene's file that is not there. reports/README.md describes the form.
void read_tuning_definition(const std::filesystem::path& file, const std::filesystem::path& scenes_dir,
                            const std::vector<std::string>& methods, TuningPlan& plan);

}  // namespace aoscore
