#include "image/environment_file.h"

#include "core/error.h"
#include "core/log.h"
#include "image/image_file.h"
#include "image/image_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace aoscore {
namespace {

using Planes = std::array<const ImageF*, 3>;

Planes planes_of(const ImageFile& file, const std::string& where) {
    const Planes colours{file.channel("R"), file.channel("G"), file.channel("B")};
    if (colours[0] != nullptr && colours[1] != nullptr && colours[2] != nullptr) return colours;
    const ImageF* gray = file.channel("Y");
    if (gray == nullptr) {
        throw file_error(fmt::format("has the channels {}", fmt::join(file.channel_names, ", ")), where,
                         "R, G and B, or Y");
    }
    return {gray, gray, gray};
}

void require_light(const ImageFile& file, const std::string& where) {
    if (file.integers)
        throw file_error("holds integers, which cut off bright light", where,
                         "floats, as in HDR and EXR files");
    if (file.width != 2 * file.height) {
        throw file_error(fmt::format("is {}x{}", file.width, file.height), where,
                         "twice as wide as high, in equirectangular projection");
    }
}

/// The value of a plane, checked.
float light_at(const ImageF& plane, std::size_t i, const std::string& where) {
    const float value = plane.pixels[i];
    if (std::isfinite(value) && value >= 0) return value;
    const auto width = static_cast<std::size_t>(plane.width);
    throw file_error(fmt::format("is {} at pixel {}, {}", value, i % width, i / width), where,
                     "finite numbers of at least 0");
}

}  // namespace

Environment read_environment(const std::filesystem::path& path, double turn_deg) {
    const std::string where = path.string();
    const ImageFile file = read_image(path);
    require_light(file, where);
    for (const std::string& doubt : file.doubts) log_warning(where + ": " + doubt);
    const Planes planes = planes_of(file, where);
    for (const ImageF* plane : planes)
        require_whole_frame(file, static_cast<std::size_t>(plane - file.channels.data()), where);
    EnvironmentMap map{Image<glm::vec3>(file.width, file.height), glm::radians(turn_deg)};
    bool is_black = true;
    for (std::size_t i = 0; i < map.radiance.size(); ++i) {
        for (int c = 0; c < 3; ++c)
            map.radiance.pixels[i][c] = light_at(*planes[static_cast<std::size_t>(c)], i, where);
        is_black = is_black && map.radiance.pixels[i] == glm::vec3(0);
    }
    if (is_black) throw file_error("is black everywhere", where, "an environment that gives light");
    std::string id = path.filename().string();
    if (turn_deg != 0) id += fmt::format(", turned by {:g}°", turn_deg);
    return {std::move(map), std::move(id)};
}

}  // namespace aoscore
