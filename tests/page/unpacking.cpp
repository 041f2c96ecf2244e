#include "page/unpacking.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <vector>

namespace aoscore::testing {

std::string bytes_of_dense_text(const std::string& text) {
    std::string digits;
    for (char c = '!'; c <= '~'; ++c) {
        if (c != '<') digits += c;
    }
    std::vector<bool> bits;
    const auto append = [&](std::size_t value, int count) {
        for (int k = 0; k < count; ++k) bits.push_back((value >> static_cast<unsigned>(k) & 1U) != 0);
    };
    for (std::size_t i = 0; i < text.size(); i += 2) {
        const std::size_t first = digits.find(text[i]);
        if (i + 1 == text.size())
            append(first, 6);
        else
            append(first * 93 + digits.find(text[i + 1]), 13);
    }
    std::string bytes;
    for (std::size_t i = 0; i + 8 <= bits.size(); i += 8) {
        unsigned byte = 0;
        for (unsigned k = 0; k < 8; ++k) byte |= static_cast<unsigned>(bits[i + k]) << k;
        bytes += static_cast<char>(byte);
    }
    return bytes;
}

std::string inflated(const std::string& text) {
    const std::string packed = bytes_of_dense_text(text);
    z_stream stream{};
    EXPECT_EQ(inflateInit(&stream), Z_OK);
    std::string input = packed, bytes;
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    int result = Z_OK;
    while (result == Z_OK) {
        std::string part(1 << 16, '\0');
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        result = inflate(&stream, Z_NO_FLUSH);
        bytes.append(part, 0, part.size() - stream.avail_out);
    }
    EXPECT_EQ(result, Z_STREAM_END);
    EXPECT_EQ(stream.avail_in, 0U) << "browsers refuse what follows the end";
    inflateEnd(&stream);
    return bytes;
}

}  // namespace aoscore::testing
