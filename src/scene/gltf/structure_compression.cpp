#include "scene/gltf/compressed_view.h"
#include "scene/gltf/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace aoscore::gltf {
namespace {

constexpr std::int64_t kMaxStride = 256;

void check_layout(CheckedObject& compressed, const std::string& mode, const std::string& filter,
                  std::int64_t stride, std::int64_t count) {
    if (mode == "ATTRIBUTES") {
        if (stride % 4 != 0) compressed.fail("byteStride", fmt::format("is {}", stride), "a multiple of 4");
    } else if (mode == "TRIANGLES" || mode == "INDICES") {
        if (stride != 2 && stride != 4) compressed.fail("byteStride", fmt::format("is {}", stride), "2, 4");
        if (mode == "TRIANGLES" && count % 3 != 0)
            compressed.fail("count", fmt::format("is {}", count), "a multiple of 3");
        if (filter != "NONE") compressed.fail("filter", "goes with ATTRIBUTES only", "NONE");
    } else {
        compressed.fail("mode", "is unknown", "ATTRIBUTES, TRIANGLES, INDICES");
    }
    if (filter == "QUATERNION" && stride != 8) {
        compressed.fail("byteStride", fmt::format("is {}", stride), "8");
    } else if ((filter == "OCTAHEDRAL" || filter == "COLOR") && stride != 4 && stride != 8) {
        compressed.fail("byteStride", fmt::format("is {}", stride), "4, 8");
    } else if (constexpr std::array<std::string_view, 5> kFilters = {"NONE", "OCTAHEDRAL", "QUATERNION",
                                                                     "EXPONENTIAL", "COLOR"};
               std::find(kFilters.begin(), kFilters.end(), filter) == kFilters.end()) {
        compressed.fail("filter", "is unknown", "NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL, COLOR");
    }
}

void check_compressed(CheckedObject& compressed, std::int64_t view_bytes,
                      const std::vector<std::int64_t>& buffer_bytes) {
    const std::size_t buffer = compressed.required_index("buffer", buffer_bytes.size());
    const std::int64_t offset = compressed.integer("byteOffset", 0, kMaxBytes).value_or(0);
    const std::int64_t bytes = compressed.required_integer("byteLength", 1, kMaxBytes);
    if (offset + bytes > buffer_bytes[buffer]) {
        compressed.fail("byteLength", fmt::format("ends at byte {} of a buffer of {} bytes", offset + bytes,
                                                  buffer_bytes[buffer]));
    }
    const std::int64_t stride = compressed.required_integer("byteStride", 1, kMaxStride);
    const std::int64_t count = compressed.required_integer("count", 1, kMaxCount);
    const std::string filter = compressed.has("filter") ? compressed.text("filter") : "NONE";
    check_layout(compressed, compressed.required_text("mode"), filter, stride, count);
    if (stride * count != view_bytes) {
        compressed.fail(
            "count", fmt::format("{} of {} bytes do not fill a bufferView of {}", count, stride, view_bytes));
    }
}

}  // namespace

void check_compressed_view(CheckedObject& view, std::int64_t bytes,
                           const std::vector<std::int64_t>& buffer_bytes) {
    view.object("extensions", [&](CheckedObject& extensions) {
        for (const char* name : kCompressionExtensions) {
            extensions.object(
                name, [&](CheckedObject& compressed) { check_compressed(compressed, bytes, buffer_bytes); });
        }
    });
}

}  // namespace aoscore::gltf
