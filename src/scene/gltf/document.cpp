#include "scene/gltf/document.h"

#include "core/error.h"
#include "core/json_text.h"
#include "scene/gltf/place.h"
#include "scene/gltf/structure.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <utility>

namespace aoscore::gltf {
namespace {

using nlohmann::json;

/// Takes the buffers out of the JSON and reads them.
void load_buffers(json& root, Document& document) {
    const json buffers = std::exchange(root["buffers"], json::array());
    document.loaded_buffers.resize(buffers.size());
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const json& buffer = buffers[i];
        const std::string place = fmt::format("{}: buffers[{}]", document.where, i);
        const auto stated = buffer.at("byteLength").get<std::size_t>();
        std::string_view bytes;
        // Data within the file is coded in whole 4-byte units; only a file beside it may be longer with
        // reason.
        std::size_t padding = 0;
        if (!buffer.contains("uri")) {
            // Without a chunk the buffer is one that an extension fills: legal as long as nothing reads it.
            if (i == 0 && document.container->binary_chunk) bytes = *document.container->binary_chunk;
            if (bytes.empty()) {
                document.buffers.emplace_back();
                continue;
            }
            padding = 3;
        } else {
            const auto& uri = buffer.at("uri").get_ref<const std::string&>();
            std::string& loaded = document.loaded_buffers[i];
            loaded = is_data_uri(uri) ? decode_data_uri(uri, place + ".uri")
                                      : document.folder.read(uri, place + ".uri");
            document.budget.take(loaded.size(), place);
            if (is_data_uri(uri) && !uri.starts_with("data:application/octet-stream;") &&
                !uri.starts_with("data:application/gltf-buffer;")) {
                document.warn(fmt::format("buffers[{}].uri has another media type than glTF's", i));
            }
            if (is_data_uri(uri) && loaded.size() != stated) {
                throw file_error(fmt::format("states {} bytes, its data URI has {}", stated, loaded.size()),
                                 place + ".byteLength");
            }
            bytes = loaded;
        }
        if (bytes.size() < stated) {
            throw file_error(fmt::format("states {} bytes, {} are there", stated, bytes.size()),
                             place + ".byteLength");
        }
        if (bytes.size() > stated + padding) {
            document.warn(fmt::format("buffers[{}]: {} bytes beyond its byteLength are ignored", i,
                                      bytes.size() - stated));
        }
        document.buffers.push_back(bytes.substr(0, stated));
    }
}

/// Takes the images out of the JSON; textures go on counting them.
void take_images(json& root, Document& document) {
    json images = std::exchange(root["images"], json::array());
    for (json& image : images) {
        ImageSource source;
        source.buffer_view = image.value("bufferView", -1);
        if (image.contains("uri")) source.uri = std::move(image["uri"].get_ref<std::string&>());
        document.images.push_back(std::move(source));
    }
}

/// tinygltf on what is left of the JSON, which it consumes; it has nothing to open, and could not.
std::unique_ptr<tinygltf::Model> map_to_model(json& root, const std::string& where) {
    for (const char* unread : {"buffers", "images", "animations", "skins", "extensions", "extras"})
        root.erase(unread);
    tinygltf::FsCallbacks no_files{};
    no_files.FileExists = [](const std::string&, void*) { return false; };
    no_files.ExpandFilePath = [](const std::string&, void*) { return std::string(); };
    no_files.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&, void*) {
        return false;
    };
    no_files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(no_files);
    auto model = std::make_unique<tinygltf::Model>();
    const std::string text = root.dump();
    root = nullptr;  // a large document need not be in memory three times
    std::string error, warning;
    bool loaded = false;
    try {
        loaded = loader.LoadASCIIFromString(model.get(), &error, &warning, text.data(),
                                            static_cast<unsigned>(text.size()), "");
    } catch (const std::exception&) {
        loaded = false;
    }
    // Its own messages quote the document and may span lines.
    if (!loaded) throw file_error("tinygltf does not understand the document", where, "glTF 2.0");
    return model;
}

}  // namespace

Document::Document(const std::filesystem::path& file, std::string where_text)
    : where(std::move(where_text)), folder(file) {}
Document::~Document() = default;

std::string_view Document::view_bytes(int buffer_view) const {
    const tinygltf::BufferView& view = model->bufferViews.at(static_cast<std::size_t>(buffer_view));
    const std::string_view bytes = buffers.at(static_cast<std::size_t>(view.buffer));
    if (bytes.empty()) {
        throw file_error("has neither a uri nor a BIN chunk",
                         fmt::format("{}: buffers[{}]", where, view.buffer));
    }
    return bytes.substr(view.byteOffset, view.byteLength);
}

void Document::warn(std::string text) {
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
        warnings.push_back(std::move(text));
}

std::unique_ptr<Document> open_document(const std::filesystem::path& file) {
    auto document = std::make_unique<Document>(file, printable(file.string()));
    document->container = read_container(file, document->where, document->warnings);
    document->budget.take(document->container->bytes.size(), document->where);
    json root = parse_json_text(document->container->json, document->where, "glTF 2.0");
    check_structure(root, document->where, document->warnings);
    load_buffers(root, *document);
    take_images(root, *document);
    document->model = map_to_model(root, document->where);
    return document;
}

}  // namespace aoscore::gltf
