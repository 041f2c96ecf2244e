#pragma once

#include <cstdint>
#include <cstring>

namespace aoscore {

/// Four values of 32 bits, which every machine holds in one register.
typedef std::int32_t FourWords __attribute__((vector_size(16)));

[[gnu::always_inline]] inline FourWords four_words(const void* from) {
    FourWords words;
    std::memcpy(&words, from, sizeof words);
    return words;
}

/// Makes columns of rows: afterwards `a` has the first value of each, and so on.
[[gnu::always_inline]] inline void transpose(FourWords& a, FourWords& b, FourWords& c, FourWords& d) {
    const FourWords ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                    ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const FourWords cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5),
                    cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

}  // namespace aoscore
