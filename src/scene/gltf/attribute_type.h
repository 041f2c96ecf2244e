#pragma once

#include "scene/gltf/accessors.h"

#include <string>
#include <vector>

namespace aoscore::gltf {

/// What elements glTF lets an attribute have.
struct AttributeType {
    std::vector<int> components;  ///< an element's, any of these
    bool floats = true;
    /// Unsigned bytes and shorts, normalised; for joints as they are.
    bool unsigned_integers = false;
    bool signed_normalized = false;  ///< signed bytes and shorts, normalised
    bool joints = false;
    bool quantized = false;  ///< any 8 or 16 bits where KHR_mesh_quantization is used
};

/// Throws file_error at `place` for an accessor of another type. Integers where the extension is missing from
/// extensionsUsed are read, with a warning: what they mean is plain.
void check_type(Document& document, const Accessor& accessor, const AttributeType& type,
                const std::string& place);

}  // namespace aoscore::gltf
