#pragma once

#include "jobs/planned_command.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// One process's share of the jobs of a command.
struct WorkPart {
    double cost_s = 0;  ///< estimated
    std::vector<std::string> keys;
};

/// A command's work in parts, for processes that share a cache.
struct WorkParts {
    PlannedCommand command;
    std::string times_on;  ///< the kind of node whose times count
    std::vector<WorkPart> parts;
};

/// Divides what a JobListing's JSON asks for, and nobody has made, into at most `count` parts of even
/// estimated cost. The jobs of a cell, and the times of a view, stay together, and neighbours share a part,
/// so that few parts load the same scene. Where there are fewer of these units, further parts help to trace
/// the truths, and without truths there are fewer parts.
std::vector<WorkPart> even_parts(const nlohmann::json& listing, std::size_t count);

/// {"aoscore": version, "command": what PlannedCommand::json() gives, "times_on": text, "parts": [{"cost_s":
/// n, "jobs": [key]}]}
void write_parts(const WorkParts& work, const std::filesystem::path& file);

/// Reads what write_parts() wrote. Throws file_error for another form or another version of the program.
WorkParts read_parts(const std::filesystem::path& file);

}  // namespace aoscore
