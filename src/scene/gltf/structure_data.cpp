#include "scene/gltf/structure.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore::gltf {
namespace {

struct ViewExtent {
    std::int64_t bytes = 0;
    std::int64_t stride = 0;  // 0: tightly packed
};

struct ElementLayout {
    std::int64_t element_bytes = 0;
    std::int64_t component_bytes = 0;
    std::int64_t count = 0;
};

/// Checks that `count` elements from `offset` on lie within the view.
void check_span(CheckedObject& owner, const ViewExtent& view, std::int64_t offset,
                const ElementLayout& layout) {
    const std::int64_t stride = view.stride == 0 ? layout.element_bytes : view.stride;
    if (stride < layout.element_bytes) {
        owner.fail("bufferView", fmt::format("its byteStride {} is less than an element's {} bytes", stride,
                                             layout.element_bytes));
    }
    if (layout.count == 0) return;
    const std::int64_t end = offset + stride * (layout.count - 1) + layout.element_bytes;
    if (end > view.bytes) {
        owner.fail("count",
                   fmt::format("its elements end at byte {} of a bufferView of {} bytes", end, view.bytes));
    }
}

void check_sparse(CheckedObject& sparse, const std::vector<ViewExtent>& views, const ElementLayout& base) {
    const std::int64_t count = sparse.required_integer("count", 1, base.count);
    const auto check_part = [&](std::int64_t element_bytes) {
        return [&views, count, element_bytes](CheckedObject& part) {
            const std::size_t view = part.required_index("bufferView", views.size());
            const std::int64_t offset = part.integer("byteOffset", 0, kMaxBytes).value_or(0);
            // Sparse data is always tightly packed.
            const ViewExtent packed{views[view].bytes, 0};
            check_span(part, packed, offset, {element_bytes, element_bytes, count});
        };
    };
    sparse.required_object("indices", [&](CheckedObject& indices) {
        const std::int64_t type = indices.required_integer("componentType", 0, 0xFFFF);
        if (type != 5121 && type != 5123 && type != 5125) {
            indices.fail("componentType", fmt::format("is {}", type), "5121, 5123, 5125");
        }
        check_part(static_cast<std::int64_t>(component_bytes(type)))(indices);
    });
    sparse.required_object("values", check_part(base.element_bytes));
}

/// Harmless oddities, each of which gets a warning.
struct DataOddities {
    bool misaligned = false;
    bool bad_bounds = false;
};

void check_accessor(CheckedObject& accessor, const std::vector<ViewExtent>& views, DataOddities& oddities) {
    const std::int64_t type = accessor.required_integer("componentType", 0, 0xFFFF);
    if (component_bytes(type) == 0) {
        accessor.fail("componentType", fmt::format("is {}", type), "5120, 5121, 5122, 5123, 5125, 5126");
    }
    const std::size_t components = component_count(accessor.required_text("type"));
    if (components == 0) accessor.fail("type", "is unknown", "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
    ElementLayout layout;
    layout.component_bytes = static_cast<std::int64_t>(component_bytes(type));
    layout.element_bytes = layout.component_bytes * static_cast<std::int64_t>(components);
    layout.count = accessor.required_integer("count", 0, kMaxCount);
    accessor.boolean("normalized");
    for (const char* key : {"min", "max"}) {
        if (!accessor.has(key) || accessor.holds_numbers(key, components)) continue;
        oddities.bad_bounds = true;
        accessor.erase(key);
    }
    const std::int64_t offset = accessor.integer("byteOffset", 0, kMaxBytes).value_or(0);
    if (const auto view = accessor.index("bufferView", views.size())) {
        check_span(accessor, views[*view], offset, layout);
        oddities.misaligned |= offset % layout.component_bytes != 0;
    }
    accessor.object("sparse", [&](CheckedObject& sparse) { check_sparse(sparse, views, layout); });
}

}  // namespace

std::size_t component_bytes(std::int64_t component_type) {
    switch (component_type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

std::size_t component_count(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4" || type == "MAT2") return 4;
    if (type == "MAT3") return 9;
    if (type == "MAT4") return 16;
    return 0;
}

void check_buffers_and_accessors(CheckedObject& root, const Counts& counts,
                                 std::vector<std::string>& warnings) {
    std::vector<std::int64_t> buffer_bytes;
    root.objects("buffers", [&](CheckedObject& buffer, std::size_t) {
        buffer_bytes.push_back(buffer.required_integer("byteLength", 1, kMaxBytes));
        if (buffer.has("uri") && buffer.text("uri").empty()) buffer.fail("uri", "is empty");
    });

    std::vector<ViewExtent> views;
    root.objects("bufferViews", [&](CheckedObject& view, std::size_t) {
        const std::size_t buffer = view.required_index("buffer", counts.buffers);
        const std::int64_t offset = view.integer("byteOffset", 0, kMaxBytes).value_or(0);
        const std::int64_t bytes = view.required_integer("byteLength", 1, kMaxBytes);
        const std::int64_t stride = view.integer("byteStride", 4, 252).value_or(0);
        if (stride % 4 != 0) view.fail("byteStride", fmt::format("is {}", stride), "a multiple of 4");
        if (offset + bytes > buffer_bytes[buffer]) {
            view.fail("byteLength", fmt::format("ends at byte {} of a buffer of {} bytes", offset + bytes,
                                                buffer_bytes[buffer]));
        }
        views.push_back({bytes, stride});
        check_compressed_view(view, bytes, buffer_bytes);
    });

    DataOddities oddities;
    root.objects("accessors",
                 [&](CheckedObject& accessor, std::size_t) { check_accessor(accessor, views, oddities); });
    if (oddities.misaligned)
        warnings.push_back("accessors begin at offsets that are no multiple of their component's size");
    if (oddities.bad_bounds)
        warnings.push_back("accessors have a min or max that is not one number a component: not used");
}

}  // namespace aoscore::gltf
