#pragma once

#include "scene/gltf/asset_folder.h"
#include "scene/gltf/container.h"
#include "scene/gltf/memory_budget.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace aoscore::gltf {

/// Where an image's bytes are; decoded only when a cut-out needs them.
struct ImageSource {
    std::string uri;  ///< relative or data URI, empty when it is in a buffer view
    int buffer_view = -1;
};

/// A sound glTF document: every index, type and extent is checked, every buffer is there with the bytes it
/// states. tinygltf maps the checked JSON to its structs and supplies the defaults; buffers and images are
/// taken out of the JSON before, so that it neither opens a file nor decodes anything.
struct Document {
    Document(const std::filesystem::path& file, std::string where_text);
    ~Document();

    std::string where;  ///< the file as errors name it
    AssetFolder folder;
    std::unique_ptr<const Container> container;
    std::vector<std::string> loaded_buffers;  ///< those that are not the GLB's chunk
    std::vector<std::string_view> buffers;    ///< the bytes of buffers[i]; empty for one without data
    std::vector<ImageSource> images;
    std::unique_ptr<tinygltf::Model> model;  ///< without buffers and images
    MemoryBudget budget;
    std::vector<std::string> warnings;

    /// The bytes of a buffer view. Throws file_error when its buffer has no data.
    std::string_view view_bytes(int buffer_view) const;
    /// Adds a warning unless it is there already.
    void warn(std::string text);
};

/// Reads and checks a file. Throws file_error that names file and place.
std::unique_ptr<Document> open_document(const std::filesystem::path& file);

}  // namespace aoscore::gltf
