#include "core/machine.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <string_view>

namespace aoscore {

std::string cpu_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (!line.starts_with("model name")) continue;
        if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

bool is_software_renderer(const std::string& gl_renderer) {
    constexpr std::array<std::string_view, 5> kNames{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                     "Software Rasterizer"};
    return std::ranges::any_of(
        kNames, [&](std::string_view name) { return gl_renderer.find(name) != std::string::npos; });
}

double peak_memory_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string utc_now() {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace aoscore
