#pragma once

#include "importer/import_job.h"
#include "importer/surface_materials.h"

#include <assimp/scene.h>

#include <map>
#include <optional>

namespace aoscore::importer {

/// The materials of a scene that Assimp read, added when a mesh first uses them.
class AssimpMaterials {
  public:
    AssimpMaterials(ImportJob& job, const aiScene& source);

    struct Used {
        int material = 0;                   ///< index into the scene's materials
        std::optional<TextureUse> texture;  ///< the texture that the material samples
    };
    const Used& use(unsigned material);

    /// Call it after the last use().
    void finish() { materials_.finish(); }

  private:
    ImportJob& job_;
    const aiScene& source_;
    SurfaceMaterials materials_;
    std::map<unsigned, Used> used_;
};

}  // namespace aoscore::importer
