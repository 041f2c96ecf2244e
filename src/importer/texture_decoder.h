#pragma once

#include "core/image.h"
#include "core/memory_budget.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace aoscore::importer {

/// Decodes the image formats that such scenes use: PNG, JPEG, WebP, TGA, BMP, DDS, TIFF, GIF, PSD, as
/// decode_image() does. `name` identifies a TGA, which has no signature.
std::optional<Image<glm::u8vec4>> decode_texture(const std::string& name, std::string_view bytes,
                                                 MemoryBudget& budget, std::string& reason);

/// False where the first bytes rule out an alpha.
bool may_have_alpha(std::string_view bytes);

}  // namespace aoscore::importer
