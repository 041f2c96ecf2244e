#include "scene/gltf/compressed_view.h"

#include "core/error.h"
#include "scene/gltf/colour_filter.h"

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace aoscore::gltf {
namespace {

using nlohmann::json;

void undo_filter(const CompressedView& view, std::string& bytes) {
    if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
    if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
    if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
    if (view.filter == "COLOR") decode_colours(bytes, view.stride / 4);
}

}  // namespace

std::map<int, CompressedView> compressed_views(const json& root) {
    std::map<int, CompressedView> views;
    const auto all = root.find("bufferViews");
    if (all == root.end()) return views;
    for (std::size_t i = 0; i < all->size(); ++i) {
        const auto extensions = (*all)[i].find("extensions");
        if (extensions == (*all)[i].end()) continue;
        for (const char* name : kCompressionExtensions) {
            const auto found = extensions->find(name);
            if (found == extensions->end()) continue;
            views[static_cast<int>(i)] = {found->at("buffer").get<int>(),
                                          found->value("byteOffset", std::size_t{0}),
                                          found->at("byteLength").get<std::size_t>(),
                                          found->at("byteStride").get<std::size_t>(),
                                          found->at("count").get<std::size_t>(),
                                          found->at("mode").get<std::string>(),
                                          found->value("filter", std::string("NONE"))};
        }
    }
    return views;
}

// A stream begins with a byte whose lower half is the version of the coding.
bool is_unknown_version(const CompressedView& view, std::string_view stream) {
    const bool is_attributes = view.mode == "ATTRIBUTES";
    const int family = is_attributes ? 0xA0 : view.mode == "TRIANGLES" ? 0xE0 : 0xD0;
    const int newest = is_attributes ? 0 : 1;
    const auto header = static_cast<unsigned char>(stream.front());
    return (header & 0xF0) == family && (header & 0x0F) > newest;
}

bool can_hold(const CompressedView& view) {
    // An index takes at least a byte, as do the three of a triangle; 16 bytes of attributes take at least 2
    // bits.
    if (view.mode == "TRIANGLES") return view.count / 3 < view.bytes;
    if (view.mode == "INDICES") return view.count < view.bytes;
    return view.count / 64 * view.stride <= view.bytes;
}

std::string decode_view(const CompressedView& view, std::string_view stream, const std::string& where) {
    if (!can_hold(view)) {
        throw file_error(fmt::format("states {} elements, more than a stream of {} bytes can hold",
                                     view.count, view.bytes),
                         where);
    }
    std::string bytes(view.count * view.stride, '\0');
    const auto* data = reinterpret_cast<const unsigned char*>(stream.data());
    using Decode = int(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
    Decode* decode = meshopt_decodeIndexSequence;
    if (view.mode == "ATTRIBUTES") decode = meshopt_decodeVertexBuffer;
    if (view.mode == "TRIANGLES") decode = meshopt_decodeIndexBuffer;
    if (decode(bytes.data(), view.count, view.stride, data, stream.size()) != 0) {
        throw file_error(is_unknown_version(view, stream)
                             ? "is compressed in a newer coding than meshoptimizer 0.18 decodes"
                             : "is a broken compressed stream",
                         where);
    }
    undo_filter(view, bytes);
    return bytes;
}

}  // namespace aoscore::gltf
