#include "image/image_limits.h"

#include "core/image.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>

namespace aoscore {
namespace {

constexpr int kMostChannels = 1024;
constexpr std::size_t kMostValues = std::size_t{1} << 30;
constexpr std::int64_t kLargestTextureSide_px = 8192;

}  // namespace

void require_allocatable(int width, int height, int channels, const std::string& where) {
    if (width < 1 || height < 1 || channels < 1) throw file_error("is empty", where);
    const std::size_t values = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                               static_cast<std::size_t>(channels);
    if (width <= kLargestImageSide_px && height <= kLargestImageSide_px && channels <= kMostChannels &&
        values <= kMostValues)
        return;
    throw file_error(fmt::format("claims {}x{} pixels of {} channels", width, height, channels), where,
                     fmt::format("at most {0}x{0} pixels, {1} channels, {2} values", kLargestImageSide_px,
                                 kMostChannels, kMostValues));
}

bool texture_fits(std::int64_t width, std::int64_t height, int channels, MemoryBudget& budget,
                  std::string& reason) {
    if (width < 1 || height < 1 || width > kLargestTextureSide_px || height > kLargestTextureSide_px ||
        channels < 1 || channels > 4) {
        reason = fmt::format("has {} x {} pixels of {} channels, more than the {} x {} of 4 that are read",
                             width, height, channels, kLargestTextureSide_px, kLargestTextureSide_px);
        return false;
    }
    try {
        // Counts the decoder's samples as well as the texels.
        budget.take(static_cast<std::size_t>(width * height) * 2 * sizeof(glm::u8vec4), "");
    } catch (const Error&) {
        reason = "does not fit into the memory that a scene may take (1 GiB)";
        return false;
    }
    return true;
}

Error unreadable_image(const std::string& complaint, const std::string& where) {
    std::string text = complaint;
    std::ranges::replace(text, '\n', ' ');
    return file_error("cannot be read: " + text, where, "a whole image file");
}

}  // namespace aoscore
