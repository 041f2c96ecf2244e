#pragma once

#include "core/image.h"
#include "core/memory_budget.h"
#include "image/image_file.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace aoscore {

/// Does read_image() for a regular file.
ImageFile read_picture(const std::filesystem::path& path);

/// Does decode_image_as().
std::optional<Image<glm::u8vec4>> decode_picture(const char* format, std::string_view bytes,
                                                 MemoryBudget& budget, std::string& reason);

}  // namespace aoscore
