#include "scene/gltf/buffers.h"

#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace aoscore::gltf {
namespace {

using nlohmann::json;

bool is_fallback(const json& buffer) {
    const auto extensions = buffer.find("extensions");
    if (extensions == buffer.end() || !extensions->is_object()) return false;
    return std::any_of(kCompressionExtensions.begin(), kCompressionExtensions.end(), [&](const char* name) {
        const auto found = extensions->find(name);
        if (found == extensions->end() || !found->is_object()) return false;
        const auto flag = found->find("fallback");
        return flag != found->end() && *flag == json(true);
    });
}

std::string read_uri(Document& document, const std::string& uri, std::size_t i, const std::string& place) {
    if (!is_data_uri(uri)) return document.folder.read(uri, place + ".uri");
    if (!uri.starts_with("data:application/octet-stream;") &&
        !uri.starts_with("data:application/gltf-buffer;"))
        document.warn(fmt::format("buffers[{}].uri has another media type than glTF's", i));
    return decode_data_uri(uri, place + ".uri");
}

/// Fills buffers[i] from `bytes`, which must live on.
void keep(Document& document, std::size_t i, std::string_view bytes, std::size_t stated, std::size_t padding,
          const std::string& place) {
    if (bytes.size() < stated) {
        throw file_error(fmt::format("states {} bytes, {} are there", stated, bytes.size()),
                         place + ".byteLength");
    }
    if (bytes.size() > stated + padding) {
        document.warn(
            fmt::format("buffers[{}]: {} bytes beyond its byteLength are ignored", i, bytes.size() - stated));
    }
    document.buffers[i] = bytes.substr(0, stated);
}

void load_from_uri(Document& document, std::size_t i, const std::string& uri, std::size_t stated) {
    const std::string place = fmt::format("{}: buffers[{}]", document.where, i);
    std::string& loaded = document.loaded_buffers[i];
    loaded = read_uri(document, uri, i, place);
    document.budget.take(loaded.size(), place);
    keep(document, i, loaded, stated, 0, place);
}

}  // namespace

void load_buffers(json& root, Document& document) {
    const json buffers = std::exchange(root["buffers"], json::array());
    document.loaded_buffers.resize(buffers.size());
    document.buffers.resize(buffers.size());
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const json& buffer = buffers[i];
        const auto stated = buffer.at("byteLength").get<std::size_t>();
        if (buffer.contains("uri")) {
            const auto& uri = buffer.at("uri").get_ref<const std::string&>();
            if (is_fallback(buffer)) {
                document.fallbacks[static_cast<int>(i)] = {uri, stated};
            } else {
                load_from_uri(document, i, uri, stated);
            }
            continue;
        }
        // Without a chunk an extension fills the buffer, which is legal as long as nothing reads it.
        if (i != 0 || !document.container->binary_chunk || document.container->binary_chunk->empty())
            continue;
        // A chunk is padded to a multiple of 4 bytes.
        constexpr std::size_t kPadding = 3;
        keep(document, i, *document.container->binary_chunk, stated, kPadding,
             fmt::format("{}: buffers[{}]", document.where, i));
    }
}

std::string_view fallback_bytes(Document& document, int buffer) {
    const auto i = static_cast<std::size_t>(buffer);
    const auto found = document.fallbacks.find(buffer);
    if (found != document.fallbacks.end()) {
        const auto [uri, stated] = found->second;
        document.fallbacks.erase(found);
        try {
            load_from_uri(document, i, uri, stated);
        } catch (const Error&) {
            document.loaded_buffers[i].clear();
        }
    }
    return document.buffers.at(i);
}

}  // namespace aoscore::gltf
