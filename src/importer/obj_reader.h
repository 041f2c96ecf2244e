#pragma once

#include "importer/import_job.h"

namespace aoscore::importer {

/// Reads a Wavefront OBJ file and the MTL files that it names ("Advanced Visualizer Manual", appendix B,
/// 1995). Throws file_error with the line where there is one.
void read_obj(ImportJob& job);

}  // namespace aoscore::importer
