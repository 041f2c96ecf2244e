#pragma once

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <cstddef>
#include <filesystem>

namespace aoscore::importer {

/// A file that Assimp reads by its reader of one format alone. It tries no other reader and opens no other
/// file.
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
