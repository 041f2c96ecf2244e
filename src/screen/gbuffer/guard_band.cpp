#include "screen/gbuffer/guard_band.h"

#include "core/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kWidest_px = 4096, kWidest_percent = 100;

int band_of(const GuardBand& band, int size) {
    return static_cast<int>(std::ceil(band.is_percent ? band.width * size / 100 : band.width));
}

CameraFrame widened_frame(const CameraFrame& frame, const glm::ivec2& band_px) {
    const int width = frame.width() + 2 * band_px.x, height = frame.height() + 2 * band_px.y;
    const double taller = static_cast<double>(height) / frame.height();
    Camera camera = frame.camera();
    camera.fovy_rad = 2 * std::atan(taller * std::tan(camera.fovy_rad / 2));
    camera.half_height *= taller;
    return {camera, width, height};
}

}  // namespace

glm::ivec2 GuardBand::pixels(int picture_width, int picture_height) const {
    return {band_of(*this, picture_width), band_of(*this, picture_height)};
}

GuardBand parse_guard_band(std::string_view text) {
    GuardBand band;
    band.is_percent = text.ends_with('%');
    const std::string_view number = text.substr(0, text.size() - (band.is_percent ? 1 : 0));
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), band.width);
    const bool is_number = error == std::errc() && end == number.data() + number.size();
    const double widest = band.is_percent ? kWidest_percent : kWidest_px;
    const bool is_whole = band.is_percent || band.width == std::floor(band.width);
    if (!is_number || !(band.width >= 0 && band.width <= widest) || !is_whole) {
        throw usage_error(fmt::format("\"{}\" is no width of a guard band", text), "guard-band",
                          fmt::format("whole pixels up to {:g}, such as 64, or per cent of the picture up to "
                                      "{:g}, such as 10%",
                                      kWidest_px, kWidest_percent));
    }
    if (band.width == 0) band.is_percent = false;
    return band;
}

std::string text_of(const GuardBand& band) {
    return fmt::format("{:g}{}", band.width, band.is_percent ? "%" : "");
}

Capture widened(const Capture& capture, const glm::ivec2& band_px) {
    Capture wide = capture;
    for (CameraFrame& frame : wide.cameras) frame = widened_frame(frame, band_px);
    return wide;
}

}  // namespace aoscore
