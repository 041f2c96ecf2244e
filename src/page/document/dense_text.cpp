#include "page/document/dense_text.h"

#include <cstdint>

namespace aoscore {
namespace {

constexpr std::uint32_t kBase = 93, kGroup_bits = 13, kDigit_bits = 6;

char character(std::uint32_t digit) {
    const char at = static_cast<char>('!' + digit);
    return at < '<' ? at : static_cast<char>(at + 1);
}

}  // namespace

std::string dense_text(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() * 16 / kGroup_bits + 2);
    std::uint32_t bits = 0, count = 0;
    const auto write_group = [&] {
        const std::uint32_t value = bits & ((1U << kGroup_bits) - 1);
        text += character(value / kBase);
        text += character(value % kBase);
    };
    for (const char byte : bytes) {
        bits |= std::uint32_t{static_cast<unsigned char>(byte)} << count;
        count += 8;
        if (count < kGroup_bits) continue;
        write_group();
        bits >>= kGroup_bits;
        count -= kGroup_bits;
    }
    if (count > kDigit_bits)
        write_group();
    else if (count > 0)
        text += character(bits);
    return text;
}

}  // namespace aoscore
