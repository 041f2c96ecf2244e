#pragma once

#include "core/image.h"
#include "core/memory_budget.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace aoscore::importer {

/// Decodes what scenes of these formats use as images: PNG, JPEG, WebP, TGA, BMP, DDS, TIFF, GIF, PSD, as
/// decode_image() does. `name` tells a TGA, which has no mark of its own.
std::optional<Image<glm::u8vec4>> decode_texture(const std::string& name, std::string_view bytes,
                                                 MemoryBudget& budget, std::string& reason);

/// False where the first bytes say already that the image has no alpha.
bool may_have_alpha(std::string_view bytes);

}  // namespace aoscore::importer
