#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// The command that measures one cell alone: its scene, view, size and radius, its method with preset, filter
/// and all changes of them, and the run's accuracy of the truth. The run's own command where one cell cannot
/// be asked for: an image of another program, or a preset that lies in a file.
std::string cell_command(const Results& results, const ViewRecord& view, const CellRecord& cell);

/// A script element with the commands of all cells by their ids, which the page's script unpacks when a
/// reader asks for one.
std::string command_block(const Results& results);

}  // namespace aoscore
