#include "page/document/base64.h"

#include <algorithm>
#include <cstdint>

namespace aoscore {

std::string base64(std::string_view bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t byte = k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0U;
            bits = bits << 8U | byte;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= taken ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace aoscore
