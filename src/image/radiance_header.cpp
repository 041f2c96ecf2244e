#include "image/radiance_header.h"

#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

namespace aoscore {
namespace {

/// A header longer than this is not one that a program writes.
constexpr int kMostLines = 1000;

}  // namespace

float radiance_exposure(const std::filesystem::path& path) {
    constexpr std::string_view kKey = "EXPOSURE=";
    std::ifstream in(path, std::ios::binary);
    float product = 1;
    std::string line;
    for (int i = 0; i < kMostLines && std::getline(in, line) && !line.empty(); ++i) {
        if (!line.starts_with(kKey)) continue;
        const auto begin = line.find_first_not_of(' ', kKey.size());
        float exposure = 0;
        if (begin != std::string::npos)
            std::from_chars(line.data() + begin, line.data() + line.size(), exposure);
        if (exposure > 0) product *= exposure;
    }
    return product;
}

}  // namespace aoscore
