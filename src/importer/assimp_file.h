#pragma once

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <cstddef>
#include <filesystem>

namespace aoscore::importer {

/// One file as Assimp reads it, by its reader of one format alone; no other one is ever tried, and it opens
/// no other file.
class AssimpFile {
  public:
    static constexpr std::size_t kMaxBytes = std::size_t{2} << 30;

    /// `extension` names the reader: "fbx". Throws file_error with Assimp's words.
    AssimpFile(const std::filesystem::path& file, const char* extension);

    const aiScene& scene() const { return *importer_.GetScene(); }

  private:
    Assimp::Importer importer_;
};

}  // namespace aoscore::importer
