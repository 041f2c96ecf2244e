#include "page/document/stage_link.h"

#include <fmt/format.h>

#include <string_view>

namespace aoscore {
namespace {

constexpr std::string_view kUnreserved =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/,";

}  // namespace

std::string percent_encoded(const std::string& text) {
    std::string encoded;
    for (const char c : text) {
        if (kUnreserved.find(c) != std::string_view::npos)
            encoded += c;
        else
            encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return encoded;
}

std::string stage_link(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string link = "#";
    for (const auto& [name, value] : entries)
        link += (link.size() > 1 ? "&" : "") + name + "=" + percent_encoded(value);
    return link;
}

}  // namespace aoscore
