#include "importer/fbx_visibility.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace aoscore::importer {
namespace {

// A property is its name, its type, a label, flags and a value. This one's type has the same name.

/// Reads the values of a property of a binary file: a letter for the type of each, then its bytes.
class BinaryValues {
  public:
    explicit BinaryValues(std::string_view bytes) : bytes_(bytes) {}

    bool skip_string() {
        std::uint32_t size = 0;
        if (!bytes_.starts_with('S') || !take(1, &size, sizeof size) || bytes_.size() < size) return false;
        bytes_.remove_prefix(size);
        return true;
    }
    std::optional<double> number() {
        double value = 0;
        if (!bytes_.starts_with('D') || !take(1, &value, sizeof value)) return std::nullopt;
        return value;
    }

  private:
    bool take(std::size_t skipped, void* to, std::size_t size) {
        if (bytes_.size() < skipped + size) return false;
        std::memcpy(to, bytes_.data() + skipped, size);
        bytes_.remove_prefix(skipped + size);
        return true;
    }

    std::string_view bytes_;
};

std::optional<double> value_in_binary(std::string_view after_type) {
    BinaryValues values(after_type);
    if (!values.skip_string() || !values.skip_string()) return std::nullopt;
    return values.number();
}

std::optional<double> value_in_text(std::string_view after_type) {
    for (int i = 0; i < 3; ++i) {  // the commas before the label, the flags and the value
        const std::size_t comma = after_type.find_first_of(",\n");
        if (comma == after_type.npos || after_type[comma] == '\n') return std::nullopt;
        after_type.remove_prefix(comma + 1);
    }
    after_type.remove_prefix(std::min(after_type.size(), after_type.find_first_not_of(" \t")));
    double value = 0;
    const auto result = std::from_chars(after_type.data(), after_type.data() + after_type.size(), value);
    return result.ec == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::size_t count_invisible_nodes(std::string_view content) {
    const bool is_binary = content.starts_with("Kaydara FBX Binary");
    const std::string in_binary = std::string("S\x0a\0\0\0", 5) + "Visibility";
    const std::string name_and_type =
        is_binary ? in_binary + in_binary : std::string("\"Visibility\", \"Visibility\"");
    std::size_t count = 0;
    for (std::size_t at = content.find(name_and_type); at != content.npos;
         at = content.find(name_and_type, at + 1)) {
        const std::string_view rest = content.substr(at + name_and_type.size());
        if ((is_binary ? value_in_binary(rest) : value_in_text(rest)) == 0.0) ++count;
    }
    return count;
}

}  // namespace aoscore::importer
