#pragma once

#include "importer/import_job.h"

#include <assimp/scene.h>

namespace aoscore::importer {

/// Takes unit and axes from an FBX file's global settings: UnitScaleFactor is in centimetres, each axis is
/// named with its sign.
void read_fbx_settings(ImportJob& job, const aiScene& scene);

}  // namespace aoscore::importer
