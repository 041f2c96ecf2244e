#pragma once

#include "importer/import_job.h"

namespace aoscore::importer {

/// Reads an FBX file of version 7 through Assimp: its nodes with their meshes as instances, materials,
/// cameras, unit and axes. Throws file_error.
void read_fbx(ImportJob& job);

/// Reads a stereolithography file, text or binary, through Assimp. Its normals are those of facets: flat.
void read_stl(ImportJob& job);

}  // namespace aoscore::importer
