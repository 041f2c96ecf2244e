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

/// The functions of src/formats, which read pictures of any format by OpenImageIO.
struct ImageFormats {
    /// Does read_image() for a regular file.
    ImageFile (*read)(const std::filesystem::path& path);
    /// Does decode_image_as().
    std::optional<Image<glm::u8vec4>> (*decode)(const char* format, std::string_view bytes,
                                                MemoryBudget& budget, std::string& reason);
};

/// The name of the function, declared extern "C", by which the library of src/formats gives its table.
inline constexpr const char* kImageFormatsFunction = "aoscore_image_formats";
using ImageFormatsFunction = const ImageFormats* (*)();

/// Loads them, once: OpenImageIO brings some 250 libraries, which take 0.3 s of processor time, so that only
/// a process which reads a picture that is no plain EXR waits for them. A process that is about to lose the
/// sight of its files calls this before. Throws internal_error where they cannot be loaded.
const ImageFormats& image_formats();

}  // namespace aoscore
