// Tests how the page's numbers are packed; each is read back by code that was written after the format's
// description.
#include "core/image.h"
#include "page/document/dense_text.h"
#include "page/live/live_packing.h"
#include "page/live/surface_packing.h"
#include "page/unpacking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace aoscore::testing {
namespace {

std::string random_bytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::string bytes(count, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
}

TEST(DenseText, HoldsBytesOfEveryLengthAndNothingThatEndsAScript) {
    for (std::size_t count = 0; count < 120; ++count) {
        for (const std::string& bytes : {random_bytes(count, static_cast<unsigned>(count)),
                                         std::string(count, '\0'), std::string(count, '\xff')}) {
            const std::string text = dense_text(bytes);
            EXPECT_EQ(bytes_of_dense_text(text), bytes) << count;
            EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c > ' ' && c <= '~' && c != '<'; }));
        }
    }
    EXPECT_LT(dense_text(random_bytes(13'000, 1)).size(), 13'000U * 16 / 13 + 3);
}

/// A view of a faceted bowl: each facet is a plane, whose reciprocal of depth is linear across the picture.
struct Facets {
    ImageF depth_m{90, 60};
    Image<std::uint32_t> triangles{90, 60};

    Facets() {
        for (int y = 0; y < depth_m.height; ++y) {
            for (int x = 0; x < depth_m.width; ++x) {
                const auto facet =
                    static_cast<std::uint32_t>((3 * x + y) / 40 + 10 * ((2 * y - x + 90) / 30));
                const float tilt = static_cast<float>(facet % 7) - 3,
                            lean = static_cast<float>(facet % 5) - 2;
                depth_m.at(x, y) =
                    1 / (0.2F + 1e-4F * (tilt * static_cast<float>(x) + lean * static_cast<float>(y)));
                triangles.at(x, y) = facet % 11 == 0 ? 0 : 1000 * facet;
                if (facet % 11 == 0) depth_m.at(x, y) = 100;
            }
        }
    }
};

std::vector<std::uint32_t> unfolded(const std::string& bytes) {
    const std::size_t size = bytes.size() / 4;
    std::vector<std::uint32_t> values(size);
    for (std::size_t i = 0; i < size; ++i) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k)
            value = value << 8U | static_cast<unsigned char>(bytes[k * size + i]);
        values[i] = value % 2 == 0 ? value / 2 : ~(value / 2);
    }
    return values;
}

TEST(PackedTriangles, AreReadBackExactly) {
    const Facets facets;
    const Image<std::uint32_t>& image = facets.triangles;
    const std::string bytes = inflated(pack_triangles(image));
    const std::vector<std::uint32_t> fresh = unfolded(bytes.substr(image.size()));
    const std::array<std::array<int, 2>, 4> from{{{-1, 0}, {0, -1}, {1, -1}, {-1, -1}}};
    Image<std::uint32_t> read(image.width, image.height);
    std::size_t next = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto source = static_cast<std::size_t>(bytes[image.index(x, y)]);
            if (source < from.size()) {
                read.at(x, y) = read.at(x + from[source][0], y + from[source][1]);
            } else {
                const std::uint32_t before = y > 0 ? read.at(x, y - 1) : x > 0 ? read.at(x - 1, y) : 0;
                read.at(x, y) = before + fresh.at(next++);
            }
        }
    }
    EXPECT_EQ(next, fresh.size());
    EXPECT_EQ(read.pixels, image.pixels);
}

TEST(PackedDepths, AreShortOnTrianglesAndShorterThanWithoutThem) {
    const Facets facets;
    const std::string packed = pack_depths(facets.depth_m, facets.triangles);
    EXPECT_EQ(packed, pack_depths(facets.depth_m, facets.triangles));
    EXPECT_LT(packed.size(), pack_floats(facets.depth_m).data.size());
    // Within a facet nothing is left but the rounding of floats.
    const std::vector<std::uint32_t> residuals = unfolded(inflated(packed));
    std::size_t inner = 0;
    for (int y = 1; y < facets.triangles.height; ++y) {
        for (int x = 1; x < facets.triangles.width; ++x) {
            const auto triangle = [&](int u, int v) { return facets.triangles.at(x + u, y + v); };
            const std::uint32_t own = triangle(0, 0);
            if (triangle(-1, 0) != own || triangle(0, -1) != own || triangle(-1, -1) != own || own == 0)
                continue;
            ++inner;
            const auto left = static_cast<std::int32_t>(residuals[facets.triangles.index(x, y)]);
            EXPECT_LE(std::abs(left), 8) << x << ", " << y;
        }
    }
    EXPECT_GT(inner, 1000U);
}

TEST(PackedDepths, KeepEveryBitWhateverTheTriangles) {
    std::mt19937 random(3);
    ImageF depth(17, 9);
    Image<std::uint32_t> triangles(17, 9);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        depth.pixels[i] = std::ldexp(1.0F + static_cast<float>(random() % 1000) / 1000,
                                     static_cast<int>(random() % 40) - 20);
        triangles.pixels[i] = random() % 3;
    }
    // Where no pixel before has the same triangle, the bits are those of the median's prediction plus the
    // residual.
    Image<std::uint32_t> lone(17, 9);
    for (std::size_t i = 0; i < lone.size(); ++i) lone.pixels[i] = static_cast<std::uint32_t>(i);
    const std::vector<std::uint32_t> residuals = unfolded(inflated(pack_depths(depth, lone)));
    std::vector<std::uint32_t> read(depth.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const std::size_t x = i % 17;
        const std::uint32_t left = x > 0 ? read[i - 1] : 0, up = i >= 17 ? read[i - 17] : 0;
        std::uint32_t expected = x == 0 ? up : left;
        if (x > 0 && i >= 17) {
            const std::uint32_t corner = read[i - 18];
            expected = corner >= std::max(left, up)   ? std::min(left, up)
                       : corner <= std::min(left, up) ? std::max(left, up)
                                                      : left + up - corner;
        }
        read[i] = expected + residuals[i];
        EXPECT_EQ(read[i], std::bit_cast<std::uint32_t>(depth.pixels[i])) << i;
    }
    EXPECT_EQ(unfolded(inflated(pack_depths(depth, triangles))).size(), depth.size());
}

}  // namespace
}  // namespace aoscore::testing
