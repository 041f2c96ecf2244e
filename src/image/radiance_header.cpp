#include "image/radiance_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <vector>

namespace aoscore {
namespace {

/// A header longer than this is not one that a program writes.
constexpr int kMostLines = 1000;

/// The numbers of a line's value, as many as there are; empty where one is not above 0 or not finite.
std::vector<float> numbers_above_zero(std::string_view text) {
    std::vector<float> numbers;
    while (true) {
        const auto begin = text.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return numbers;
        float number = 0;
        const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), number);
        if (error != std::errc() || !(number > 0) || std::isinf(number)) return {};
        numbers.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
}

void add_line(std::string_view line, RadianceHeader& header) {
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view key = line.substr(0, equals);
    const std::string_view value = line.substr(equals + 1);
    if (key == "FORMAT") header.format = value.substr(0, value.find_last_not_of(" \t\r") + 1);
    const std::vector<float> numbers = numbers_above_zero(value);
    if (key == "GAMMA" && numbers.size() == 1) header.gamma = numbers[0];
    if (key != "EXPOSURE" && key != "COLORCORR") return;
    if (numbers.size() != (key == "EXPOSURE" ? 1 : header.factors.size())) {
        if (header.wrong_factor.empty())
            header.wrong_factor = line.substr(0, line.find_last_not_of(" \t\r") + 1);
        return;
    }
    for (std::size_t c = 0; c < header.factors.size(); ++c)
        header.factors[c] *= numbers[std::min(c, numbers.size() - 1)];
}

}  // namespace

RadianceHeader read_radiance_header(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    RadianceHeader header;
    std::string line;
    if (!std::getline(in, line) || !line.starts_with("#?")) return header;
    for (int i = 0; i < kMostLines && std::getline(in, line) && !line.empty(); ++i) add_line(line, header);
    return header;
}

}  // namespace aoscore
