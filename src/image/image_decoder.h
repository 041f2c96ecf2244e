#pragma once

#include "core/image.h"
#include "core/memory_budget.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace aoscore {

/// Decodes a PNG, JPEG or WebP image to 8-bit RGBA as stored: no colour conversion, alpha not multiplied in,
/// 255 where the file has none. Returns nothing when the bytes are no such image (KTX2, DDS and AVIF are
/// named), are broken, or state more than 8192 x 8192 pixels; `reason` then says why. Takes its memory from
/// the budget; `reason` says when that is not enough.
std::optional<Image<glm::u8vec4>> decode_image(std::string_view bytes, MemoryBudget& budget,
                                               std::string& reason);

/// Does the same for another format, named as OpenImageIO names its reader, such as "targa".
std::optional<Image<glm::u8vec4>> decode_image_as(const char* format, std::string_view bytes,
                                                  MemoryBudget& budget, std::string& reason);

}  // namespace aoscore
