#pragma once

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <filesystem>

namespace aoscore::importer {

/// One file as Assimp reads it, by its reader of one format alone; no other one is ever tried, and it opens
/// no other file.
class AssimpFile {
  public:
    /// `extension` names the reader: "fbx". Throws file_error with Assimp's words.
    AssimpFile(const std::filesystem::path& file, const char* extension);

    const aiScene& scene() const { return *importer_.GetScene(); }

  private:
    Assimp::Importer importer_;
};

}  // namespace aoscore::importer
