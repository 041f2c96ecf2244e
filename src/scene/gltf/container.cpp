#include "scene/gltf/container.h"

#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <cstdint>

namespace aoscore::gltf {
namespace {

constexpr std::size_t kMaxContainerBytes = std::size_t{1} << 30;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBeforeJson = "\xEF\xBB\xBF \t\r\n";

/// Reads a little-endian number on any machine.
std::uint32_t uint32_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

void split_glb(const std::string& where, Container& container, std::vector<std::string>& warnings) {
    std::string_view rest = container.bytes;
    if (rest.size() < 12) throw file_error("ends within the 12 bytes of the GLB header", where);
    const std::uint32_t version = uint32_at(rest, 4);
    if (version != 2)
        throw file_error(fmt::format("GLB container of version {}", version), where + ": header", "2");
    const std::uint32_t length = uint32_at(rest, 8);
    if (length > rest.size() || length < 12) {
        throw file_error(fmt::format("the GLB header states {} bytes, the file has {}", length, rest.size()),
                         where + ": header");
    }
    if (length < rest.size()) {
        warnings.push_back(
            fmt::format("{} bytes after the GLB's stated end are ignored", rest.size() - length));
    }
    rest = rest.substr(12, length - 12);

    for (std::size_t chunk = 0; !rest.empty() || chunk == 0; ++chunk) {
        const std::string place = fmt::format("{}: chunk {}", where, chunk);
        if (rest.size() < 8) throw file_error("ends within a chunk's header", place);
        const std::size_t chunk_bytes = uint32_at(rest, 0);
        const std::uint32_t type = uint32_at(rest, 4);
        rest.remove_prefix(8);
        if (chunk_bytes > rest.size()) {
            throw file_error(fmt::format("states {} bytes, {} are left", chunk_bytes, rest.size()), place);
        }
        if (chunk_bytes % 4 != 0) throw file_error("its length is not a multiple of 4", place);
        const std::string_view content = rest.substr(0, chunk_bytes);
        rest.remove_prefix(chunk_bytes);
        if ((chunk == 0) != (type == kJsonChunk)) {
            throw file_error(chunk == 0 ? "is not the JSON chunk" : "is a second JSON chunk", place,
                             "JSON first, then at most one BIN chunk");
        }
        if (chunk == 0) {
            container.json = content;
        } else if (type == kBinaryChunk) {
            // Chunks of unknown type are legal behind it; a second BIN chunk, or a later one, is not.
            if (chunk != 1) throw file_error("is a misplaced BIN chunk", place, "BIN as chunk 1");
            container.binary_chunk = content;
        }
    }
}

}  // namespace

std::unique_ptr<const Container> read_container(const std::filesystem::path& file, const std::string& where,
                                                std::vector<std::string>& warnings) {
    auto container = std::make_unique<Container>();
    container->bytes = read_file(file, kMaxContainerBytes);
    const std::string_view bytes = container->bytes;
    if (bytes.empty()) throw file_error("is empty", where, "a glTF 2.0 file (.gltf, .glb)");
    const bool is_glb = bytes.starts_with("glTF");
    if (is_glb) {
        split_glb(where, *container, warnings);
    } else if (bytes.find_first_not_of(kBeforeJson) == std::string_view::npos ||
               bytes[bytes.find_first_not_of(kBeforeJson)] != '{') {
        throw file_error("is no glTF: it begins neither with \"glTF\" nor as JSON", where,
                         "a glTF 2.0 file (.gltf, .glb)");
    } else {
        container->json = bytes;
    }
    if (is_glb && file.extension() == ".gltf") warnings.push_back("is a GLB, though its name ends in .gltf");
    if (!is_glb && file.extension() == ".glb") warnings.push_back("is JSON, though its name ends in .glb");
    if (container->json.starts_with(kByteOrderMark)) {
        container->json.remove_prefix(kByteOrderMark.size());
        warnings.push_back("the byte order mark before the JSON is ignored");
    }
    return container;
}

}  // namespace aoscore::gltf
