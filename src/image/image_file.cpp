#include "image/image_file.h"

#include "core/error.h"
#include "image/image_formats.h"
#include "image/plain_exr.h"

#include <algorithm>
#include <utility>

namespace aoscore {

namespace fs = std::filesystem;

std::optional<std::size_t> ImageFile::index(const std::string& name) const {
    const auto found = std::ranges::find(channel_names, name);
    if (found == channel_names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - channel_names.begin());
}

const ImageF* ImageFile::channel(const std::string& name) const {
    const auto found = index(name);
    return found ? &channels[*found] : nullptr;
}

ImageFile read_image(const fs::path& path) {
    std::error_code ec;
    const fs::file_status status = fs::status(path, ec);
    if (!fs::exists(status)) throw file_error("no such file", path.string());
    if (!fs::is_regular_file(status)) throw file_error("not a regular file", path.string());
    if (std::optional<ImageFile> plain = read_plain_exr(path)) return *std::move(plain);
    return image_formats().read(path);
}

}  // namespace aoscore
