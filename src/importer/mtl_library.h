#pragma once

#include "importer/import_job.h"
#include "importer/surface_materials.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore::importer {

/// The materials of an OBJ file's libraries, by name, added to the scene when a face first uses them.
class MtlLibrary {
  public:
    /// Reads the libraries from the scene's folder; `names` holds the words after each mtllib.
    MtlLibrary(ImportJob& job, const std::vector<std::string>& names);

    struct Used {
        int material = 0;                   ///< index into the scene's materials
        std::optional<TextureUse> texture;  ///< the texture that the material samples
    };
    /// The material of that name; where there is none, a default one, with a warning.
    const Used& use(const std::string& name);

    /// Call it after the last use().
    void finish();

  private:
    void read(const std::string& library);
    void distrust_opacity();

    ImportJob& job_;
    SurfaceMaterials materials_;
    std::map<std::string, MaterialSource> sources_;
    std::map<std::string, Used> used_;
    std::set<std::string> unknown_;
};

}  // namespace aoscore::importer
