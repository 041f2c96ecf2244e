#include "importer/assimp_file.h"

#include "core/error.h"
#include "core/files.h"
#include "scene/gltf/place.h"

#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/config.h>

#include <string>
#include <vector>

namespace aoscore::importer {
namespace {

/// A file system without files.
class NoFiles : public Assimp::IOSystem {
  public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

void keep_only(Assimp::Importer& importer, const char* extension) {
    const Assimp::BaseImporter* wanted = importer.GetImporter(extension);
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        if (importer.GetImporter(i) != wanted) others.push_back(importer.GetImporter(i));
    }
    for (Assimp::BaseImporter* other : others) {
        importer.UnregisterLoader(other);
        delete other;
    }
}

}  // namespace

AssimpFile::AssimpFile(const std::filesystem::path& file, const char* extension) {
    keep_only(importer_, extension);
    importer_.SetIOHandler(new NoFiles);
    // Pivots become part of their node's transform, instead of a chain of nodes each.
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ALL_GEOMETRY_LAYERS, false);
    const std::string content = read_file(file, kMaxBytes);
    if (content.empty()) throw file_error("is empty", "");
    if (importer_.ReadFileFromMemory(content.data(), content.size(), 0, extension) == nullptr) {
        throw file_error("cannot be understood: " + gltf::printable(importer_.GetErrorString()), "");
    }
}

}  // namespace aoscore::importer
