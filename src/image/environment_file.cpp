#include "image/environment_file.h"

#include "core/error.h"
#include "core/log.h"
#include "image/image_file.h"
#include "image/image_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/trigonometric.hpp>

#include <algorithm>
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

// Lossy compression and filters leave values just below 0: the pictures of light that Blender 3.4 ships,
// packed by DWA, have some, which together take off less than 3e-7 of the light. What takes off more than
// this is no light.
constexpr double kMostBelowZero = 1e-3;

[[noreturn]] void refuse_pixel(const ImageF& plane, std::size_t i, const std::string& where) {
    const auto width = static_cast<std::size_t>(plane.width);
    throw file_error(fmt::format("is {} at pixel {}, {}", plane.pixels[i], i % width, i / width), where,
                     "finite numbers of at least 0");
}

/// Throws file_error where a value is no light, and warns where some are below 0 by so little that they count
/// as 0.
void check_values(const Planes& planes, const std::string& where) {
    double light = 0, below = 0;
    std::size_t count = 0;
    for (const ImageF* plane : planes) {
        for (std::size_t i = 0; i < plane->size(); ++i) {
            const float value = plane->pixels[i];
            if (!std::isfinite(value)) refuse_pixel(*plane, i, where);
            (value < 0 ? below : light) += std::abs(double{value});
            count += value < 0 ? 1 : 0;
        }
    }
    if (count == 0) return;
    for (const ImageF* plane : planes) {
        const auto negative = std::ranges::find_if(plane->pixels, [](float value) { return value < 0; });
        if (below > kMostBelowZero * light && negative != plane->pixels.end())
            refuse_pixel(*plane, static_cast<std::size_t>(negative - plane->pixels.begin()), where);
    }
    log_warning(
        fmt::format("{}: {} values are below 0, by {:.2g} of the light in all, as lossy compression leaves "
                    "them: they count as 0",
                    where, count, below / light));
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
    check_values(planes, where);
    EnvironmentMap map{Image<glm::vec3>(file.width, file.height), glm::radians(turn_deg)};
    bool is_black = true;
    for (std::size_t i = 0; i < map.radiance.size(); ++i) {
        for (int c = 0; c < 3; ++c)
            map.radiance.pixels[i][c] = std::max(planes[static_cast<std::size_t>(c)]->pixels[i], 0.0F);
        is_black = is_black && map.radiance.pixels[i] == glm::vec3(0);
    }
    if (is_black) throw file_error("is black everywhere", where, "an environment that gives light");
    std::string id = path.filename().string();
    if (turn_deg != 0) id += fmt::format(", turned by {:g}°", turn_deg);
    return {std::move(map), std::move(id)};
}

}  // namespace aoscore
