#pragma once

#include "core/error.h"
#include "core/files.h"
#include "image/image_file.h"
#include "image/visibility_file.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace aoscore::testing {

inline const VisibilityReading kLinear{.channel = {}, .coding = Coding::linear},
    kSrgb{.channel = {}, .coding = Coding::srgb};

/// Random floats: every bit pattern is equally likely.
inline ImageF random_bits(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageF image(width, height);
    for (float& value : image.pixels) {
        const std::uint32_t bits = random();
        std::memcpy(&value, &bits, sizeof value);
    }
    return image;
}

inline ImageF random_visibility(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> values(0, 1);
    ImageF image(width, height);
    for (float& value : image.pixels) value = values(random);
    return image;
}

/// Whether all bits are equal, NaN and signed zeros included.
inline bool same_bits(const ImageF& a, const ImageF& b) {
    return a.same_size(b) && std::memcmp(a.pixels.data(), b.pixels.data(), a.size() * sizeof(float)) == 0;
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The message of the file_error that `action` must throw.
inline std::string file_error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
        return e.what();
    }
    return "no error";
}

inline std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace aoscore::testing
