#include "core/printable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace aoscore {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// One character of a UTF-8 text; `bytes` is 0 where the text is none.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;
};

// The Unicode Standard 15.0, table 3-7: neither longer forms than needed, nor surrogates.
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return {byte(0), 1};
    const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return {};
    std::uint32_t code = byte(0) & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    constexpr std::uint32_t kLeast[] = {0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kLeast[size - 2] || code > 0x10FFFF || surrogate) return {};
    return {code, size};
}

bool is_printable(std::uint32_t code) {
    const auto within = [code](std::uint32_t first, std::uint32_t last) {
        return code >= first && code <= last;
    };
    const bool control = code < 0x20 || within(0x7F, 0x9F);
    const bool separator = within(0x2028, 0x2029);
    // Unicode Standard Annex #9, section 2: what embeds, overrides, isolates or marks a direction.
    const bool direction =
        code == 0x061C || within(0x200E, 0x200F) || within(0x202A, 0x202E) || within(0x2066, 0x2069);
    const bool no_character = within(0xFDD0, 0xFDEF) || (code & 0xFFFE) == 0xFFFE;
    return !control && !separator && !direction && !no_character;
}

std::string cleaned(std::string_view text, std::string_view kept) {
    const auto plain = [kept](char c) { return (c >= 0x20 && c < 0x7F) || kept.find(c) != kept.npos; };
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, plain) - text.begin());
        result += text.substr(0, end);
        text.remove_prefix(end);
        if (text.empty()) break;
        const Character character = first_character(text);
        const bool shown = character.bytes > 0 && is_printable(character.code);
        const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
        result += shown ? text.substr(0, bytes) : kReplacement;
        text.remove_prefix(bytes);
    }
    return result;
}

}  // namespace

std::string printable(std::string_view text) {
    return cleaned(text, "");
}

std::string printable_lines(std::string_view text) {
    return cleaned(text, "\n\t");
}

}  // namespace aoscore
