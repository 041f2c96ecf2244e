#pragma once

#include "scene/gltf/accessors.h"

#include <string>
#include <vector>

namespace aoscore::gltf {

/// The types of elements that glTF allows an attribute to have.
struct AttributeType {
    std::vector<int> components;  ///< allowed numbers of components of an element
    bool floats = true;
    /// Unsigned bytes and shorts are allowed, normalised; for joints they are indices.
    bool unsigned_integers = false;
    bool signed_normalized = false;  ///< signed bytes and shorts are allowed, normalised
    bool joints = false;
    bool quantized = false;  ///< any 8 or 16 bits are allowed with KHR_mesh_quantization
};

/// Throws file_error at `place` for an accessor of another type. Integers where the extension is missing from
/// extensionsUsed are read, with a warning: what they mean is plain.
void check_type(Document& document, const Accessor& accessor, const AttributeType& type,
                const std::string& place);

}  // namespace aoscore::gltf
