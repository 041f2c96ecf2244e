#pragma once

#include "jobs/contest/command_image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// Writes what a command needs into `folder`, request.json first, and returns its words with all placeholders
/// replaced. Throws file_error where the command needs a scene and the view is a frame without one.
std::vector<std::string> write_command_request(const OutsideMethod& outside, const CommandRun& run,
                                               const ContestantSources& sources,
                                               const std::filesystem::path& folder);

/// The cost that a command has left in cost.json of the folder: "ms" and "on"; empty without the file. Throws
/// file_error for another form.
std::optional<ReportedCost> read_reported_cost(const std::filesystem::path& folder);

}  // namespace aoscore
