#pragma once

#include "scene/gltf/document.h"

#include <nlohmann/json_fwd.hpp>

namespace aoscore::gltf {

/// Takes the buffers out of the JSON and reads them, except for fallback buffers, which repeat compressed
/// data without compression. Throws file_error for a buffer that is not there or shorter than it states.
void load_buffers(nlohmann::json& root, Document& document);

/// The bytes of a fallback buffer, read at the first call; empty when it has none, or its file is not there.
std::string_view fallback_bytes(Document& document, int buffer);

}  // namespace aoscore::gltf
