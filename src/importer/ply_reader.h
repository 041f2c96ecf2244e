#pragma once

#include "importer/import_job.h"

namespace aoscore::importer {

/// Reads a Stanford polygon file, text or binary (Turk, "The PLY Polygon File Format", 1994): faces and
/// triangle strips; other elements, whatever they hold and wherever they stand, are passed over. Throws
/// file_error. (Assimp 5.2 misreads a binary file whose first number begins with the byte of a line feed, and
/// one with an element that it does not know before its vertices.)
void read_ply(ImportJob& job);

}  // namespace aoscore::importer
