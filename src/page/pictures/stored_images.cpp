#include "page/pictures/stored_images.h"

#include "core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {

namespace fs = std::filesystem;

fs::path stored_path(const fs::path& folder, const std::string& file) {
    const fs::path relative = fs::path(file).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") {
        throw file_error(fmt::format("names an image outside its folder, \"{}\"", file),
                         (folder / "results.json").string(), "a file beside it");
    }
    return folder / relative;
}

const ImageF& channel_of(const ImageFile& file, const fs::path& path, const std::string& name) {
    const ImageF* image = file.channel(name);
    if (image == nullptr) {
        throw file_error(fmt::format("has no channel {}", name), path.string(),
                         fmt::format("{}", fmt::join(file.channel_names, ", ")));
    }
    return *image;
}

}  // namespace aoscore
