#include "support/spoilt.h"

#include <vector>

namespace aoscore::testing {

std::string spoilt(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    const std::size_t edits = 1 + below(4);
    for (std::size_t edit = 0; edit < edits && bytes.size() > 8; ++edit) {
        const std::size_t at = below(bytes.size());
        switch (below(6)) {
            case 0:
                bytes[at] = static_cast<char>(below(256));
                break;
            case 1:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                break;
            case 2:
                bytes.resize(at);
                break;
            case 3:
                bytes.erase(at, 1 + below(16));
                break;
            case 4:
                bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(16)));
                break;
            default: {
                // Numbers carry the meaning, so a digit is replaced by another, or by a few.
                const std::size_t digit = bytes.find_first_of("0123456789", at);
                if (digit != std::string::npos)
                    bytes.replace(
                        digit, 1,
                        std::vector<std::string>{"0", "9", "-1", "4294967295", "1e9", "0.5"}[below(6)]);
            }
        }
    }
    return bytes;
}

}  // namespace aoscore::testing
