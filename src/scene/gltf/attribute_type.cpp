#include "scene/gltf/attribute_type.h"

#include "core/error.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

namespace aoscore::gltf {
namespace {

bool is_plain(const Accessor& accessor, const AttributeType& type) {
    switch (accessor.component_type()) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return type.floats;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return type.joints || (type.unsigned_integers && accessor.normalized());
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return type.signed_normalized && accessor.normalized();
        default:
            return false;
    }
}

}  // namespace

void check_type(Document& document, const Accessor& accessor, const AttributeType& type,
                const std::string& place) {
    const bool fits = std::find(type.components.begin(), type.components.end(), accessor.components()) !=
                      type.components.end();
    if (fits && is_plain(accessor, type)) return;
    const bool is_small = accessor.component_type() != TINYGLTF_COMPONENT_TYPE_FLOAT &&
                          accessor.component_type() != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!fits || !type.quantized || !is_small) {
        throw file_error(accessor.name() + " has a type that it may not have", place,
                         type.joints ? "VEC4 of unsigned bytes or shorts"
                                     : "floats; small integers where glTF allows them");
    }
    const auto& used = document.model->extensionsUsed;
    if (std::find(used.begin(), used.end(), "KHR_mesh_quantization") == used.end())
        document.warn("attributes are integers, though extensionsUsed lacks KHR_mesh_quantization");
}

}  // namespace aoscore::gltf
