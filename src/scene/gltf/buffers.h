#pragma once

#include "scene/gltf/document.h"

#include <nlohmann/json_fwd.hpp>

namespace aoscore::gltf {

/// Takes the buffers out of the JSON and reads them, but for those that only hold without compression what
/// other buffers hold with it. Throws file_error for one that is not there or shorter than it states.
void load_buffers(nlohmann::json& root, Document& document);

/// The bytes of such a fallback buffer, read when first asked for; empty when it has none, or the file beside
/// it is not there.
std::string_view fallback_bytes(Document& document, int buffer);

}  // namespace aoscore::gltf
