#include "scene/gltf/document.h"

#include "core/error.h"
#include "core/json_text.h"
#include "scene/gltf/buffers.h"
#include "scene/gltf/place.h"
#include "scene/gltf/structure.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace aoscore::gltf {
namespace {

using nlohmann::json;

/// Takes the images out of the JSON; textures keep their indices.
void take_images(json& root, Document& document) {
    json images = std::exchange(root["images"], json::array());
    for (json& image : images) {
        ImageSource source;
        source.buffer_view = image.value("bufferView", -1);
        if (image.contains("uri")) source.uri = std::move(image["uri"].get_ref<std::string&>());
        document.images.push_back(std::move(source));
    }
}

/// Takes the skins out of the JSON.
void take_skins(json& root, Document& document) {
    const json skins = std::exchange(root["skins"], json::array());
    for (const json& skin : skins) {
        document.skins.push_back(
            {skin.at("joints").get<std::vector<int>>(), skin.value("inverseBindMatrices", -1)});
    }
}

/// The node that a channel of an animation targets, by its number or, in KHR_animation_pointer, by a pointer
/// to one of its properties; none where it makes no sense.
std::optional<int> animated_node(const json& channel) {
    static const json::json_pointer node("/target/node"),
        pointer("/target/extensions/KHR_animation_pointer/pointer");
    if (!channel.is_object()) return std::nullopt;
    if (channel.contains(node) && channel.at(node).is_number_integer()) return channel.at(node).get<int>();
    if (!channel.contains(pointer) || !channel.at(pointer).is_string()) return std::nullopt;
    constexpr std::string_view kNodes = "/nodes/";
    const auto& path = channel.at(pointer).get_ref<const std::string&>();
    int index = 0;
    if (!path.starts_with(kNodes)) return std::nullopt;
    const char *const first = path.data() + kNodes.size(), *const last = path.data() + path.size();
    if (std::from_chars(first, last, index).ec != std::errc()) return std::nullopt;
    return index;
}

/// The nodes that animations target. Nothing else of an animation is read: a broken one is no error.
std::set<int> animated_nodes(const json& root) {
    std::set<int> nodes;
    for (const json& animation : root.value("animations", json::array())) {
        const json channels = animation.value("channels", json());
        for (const json& channel : channels.is_array() ? channels : json::array()) {
            if (const auto node = animated_node(channel)) nodes.insert(*node);
        }
    }
    return nodes;
}

/// Runs tinygltf on the rest of the JSON, and clears that. It has no file to open, and could not open one.
std::unique_ptr<tinygltf::Model> map_to_model(json& root, const std::string& where) {
    for (const char* unread : {"buffers", "images", "skins", "animations", "extensions", "extras"})
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
    // tinygltf's own messages quote the document and may span lines.
    if (!loaded) throw file_error("tinygltf does not understand the document", where, "glTF 2.0");
    return model;
}

}  // namespace

Document::Document(const std::filesystem::path& file, std::string where_text)
    : where(std::move(where_text)), folder(file) {}
Document::~Document() = default;

std::string_view Document::view_bytes(int buffer_view) {
    const auto found = compressed.find(buffer_view);
    if (found != compressed.end()) return decoded_bytes(buffer_view, found->second);
    const tinygltf::BufferView& view = model->bufferViews.at(static_cast<std::size_t>(buffer_view));
    fallback_bytes(*this, view.buffer);
    return stored_bytes(view.buffer, view.byteOffset, view.byteLength);
}

std::string_view Document::stored_bytes(int buffer, std::size_t offset, std::size_t count) const {
    const std::string_view bytes = buffers.at(static_cast<std::size_t>(buffer));
    if (bytes.empty()) {
        throw file_error("has neither a uri nor a BIN chunk", fmt::format("{}: buffers[{}]", where, buffer));
    }
    return bytes.substr(offset, count);
}

std::string_view Document::decoded_bytes(int buffer_view, const CompressedView& view) {
    if (const auto known = decoded_.find(buffer_view); known != decoded_.end()) return known->second;
    const std::string place = fmt::format("{}: bufferViews[{}]", where, buffer_view);
    const std::string_view stream = stored_bytes(view.buffer, view.offset, view.bytes);
    if (is_unknown_version(view, stream)) {
        const tinygltf::BufferView& plain = model->bufferViews.at(static_cast<std::size_t>(buffer_view));
        if (!fallback_bytes(*this, plain.buffer).empty()) {
            warn("compressed bufferViews of a newer coding are not decoded: the fallback buffer's are taken");
            return stored_bytes(plain.buffer, plain.byteOffset, plain.byteLength);
        }
    }
    if (can_hold(view)) budget.take(view.count * view.stride, place);
    return decoded_.emplace(buffer_view, decode_view(view, stream, place)).first->second;
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
    take_skins(root, *document);
    document->animated_nodes = animated_nodes(root);
    document->compressed = compressed_views(root);
    document->model = map_to_model(root, document->where);
    return document;
}

}  // namespace aoscore::gltf
