#include "scene/gltf/draco_header.h"

#include "core/error.h"

#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/geometry_metadata.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace aoscore::gltf {
namespace {

/// Entropy coding may take less than a bit for a face of a regular mesh, but never so little.
constexpr std::size_t kMaxFacesPerByte = 1000;

struct Header {
    std::array<char, 5> magic{};
    std::uint8_t major = 0, minor = 0, geometry = 0, method = 0;
    std::uint16_t flags = 0;
};

bool read(draco::DecoderBuffer& buffer, Header& header) {
    return buffer.Decode(header.magic.data(), header.magic.size()) && buffer.Decode(&header.major) &&
           buffer.Decode(&header.minor) && buffer.Decode(&header.geometry) && buffer.Decode(&header.method) &&
           buffer.Decode(&header.flags) &&
           std::string_view(header.magic.data(), header.magic.size()) == "DRACO";
}

bool skip_metadata(draco::DecoderBuffer& buffer) {
    draco::GeometryMetadata metadata;
    draco::MetadataDecoder decoder;
    return decoder.DecodeGeometryMetadata(&buffer, &metadata);
}

/// Reads the number of faces of the edgebreaker's coding; the sequential decoder checks its own.
bool read_faces(draco::DecoderBuffer& buffer, const Header& header, std::uint32_t& faces) {
    constexpr std::uint16_t kHasMetadata = 0x8000;
    if ((header.flags & kHasMetadata) != 0 && !skip_metadata(buffer)) return false;
    std::uint8_t traversal = 0;
    std::uint32_t unread = 0;
    if (!buffer.Decode(&traversal)) return false;
    if (header.minor < 2 && !draco::DecodeVarint(&unread, &buffer)) return false;
    return draco::DecodeVarint(&unread, &buffer) && draco::DecodeVarint(&faces, &buffer);
}

}  // namespace

std::size_t stated_draco_faces(std::string_view stream, const std::string& where) {
    constexpr std::uint8_t kTriangles = 1, kEdgebreaker = 1;
    draco::DecoderBuffer buffer;
    buffer.Init(stream.data(), stream.size());
    Header header;
    if (!read(buffer, header)) throw file_error("is no Draco stream", where);
    if (header.major != 2) {
        throw file_error(fmt::format("is of version {}.{} of Draco's bitstream", header.major, header.minor),
                         where, "2.x");
    }
    if (header.geometry != kTriangles) throw file_error("is a Draco stream without triangles", where);
    buffer.set_bitstream_version(static_cast<std::uint16_t>(header.major << 8 | header.minor));
    std::uint32_t faces = 0;
    if (header.method == kEdgebreaker && !read_faces(buffer, header, faces))
        throw file_error("is a broken Draco stream", where);
    if (faces > stream.size() * kMaxFacesPerByte) {
        throw file_error(
            fmt::format("states {} faces, more than a stream of {} bytes can hold", faces, stream.size()),
            where);
    }
    return faces;
}

}  // namespace aoscore::gltf
