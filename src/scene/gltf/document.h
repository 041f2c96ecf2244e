#pragma once

#include "core/memory_budget.h"
#include "scene/gltf/asset_folder.h"
#include "scene/gltf/compressed_view.h"
#include "scene/gltf/container.h"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tinygltf {
class Model;
}

namespace aoscore::gltf {

/// The place of an image's bytes, which are decoded only when a cut-out needs them.
struct ImageSource {
    std::string uri;  ///< relative or data URI, empty when it is in a buffer view
    int buffer_view = -1;
};

/// The nodes that move a mesh's vertices, and the matrices that take a vertex to each of them.
struct SkinSource {
    std::vector<int> joints;
    int inverse_bind_matrices = -1;  ///< accessor; -1: identities
};

/// A sound glTF document: every index, type and extent is checked, every buffer is there with the bytes it
/// states. tinygltf maps the checked JSON to its structs and supplies the defaults; buffers and images are
/// taken out of the JSON before, so that it neither opens a file nor decodes anything. The other members hold
/// what its structs lack.
struct Document {
    Document(const std::filesystem::path& file, std::string where_text);
    ~Document();

    std::string where;  ///< the file as errors name it
    AssetFolder folder;
    std::unique_ptr<const Container> container;
    std::vector<std::string> loaded_buffers;  ///< contents of buffers outside of the GLB's chunk
    std::vector<std::string_view> buffers;    ///< the bytes of buffers[i]; empty for one without data
    std::map<int, std::pair<std::string, std::size_t>> fallbacks;  ///< buffers not read: URI, stated size
    std::vector<ImageSource> images;
    std::vector<SkinSource> skins;
    std::set<int> animated_nodes;  ///< those that an animation targets
    std::map<int, CompressedView> compressed;  ///< by index of the buffer view
    std::unique_ptr<tinygltf::Model> model;    ///< without buffers, images, skins, animations
    MemoryBudget budget;
    std::vector<std::string> warnings;

    /// The bytes of a buffer view, decoded where it is compressed (once). Throws file_error when its buffer
    /// has no data, and for a broken stream. Where a stream's coding is unknown and the buffer view has a
    /// fallback, that is taken, with a warning.
    std::string_view view_bytes(int buffer_view);
    /// Adds a warning unless it is there already.
    void warn(std::string text);

  private:
    std::string_view stored_bytes(int buffer, std::size_t offset, std::size_t count) const;
    std::string_view decoded_bytes(int buffer_view, const CompressedView& view);

    std::map<int, std::string> decoded_;  // by index of the buffer view
};

/// Reads and checks a file. Throws file_error that names file and place.
std::unique_ptr<Document> open_document(const std::filesystem::path& file);

}  // namespace aoscore::gltf
