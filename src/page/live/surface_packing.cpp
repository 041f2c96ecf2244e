#include "page/live/surface_packing.h"

#include "page/document/deflate.h"
#include "page/document/dense_text.h"
#include "page/live/live_packing.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace aoscore {
namespace {

/// A pixel seen from another.
struct Offset {
    int x, y;
};

/// The pixels that a triangle's number, or a depth, is taken over from.
constexpr std::array<Offset, 4> kTakenFrom{{{-1, 0}, {0, -1}, {1, -1}, {-1, -1}}};

/// Pixels of which a + b - c lies at the pixel itself.
struct Plane {
    Offset a, b, c;
};
constexpr std::array<Plane, 10> kPlanes{{{{-1, 0}, {0, -1}, {-1, -1}},
                                         {{-1, 0}, {1, -1}, {0, -1}},
                                         {{-1, -1}, {1, -1}, {0, -2}},
                                         {{0, -1}, {-1, -1}, {-1, -2}},
                                         {{0, -1}, {1, -1}, {1, -2}},
                                         {{-1, 0}, {-1, -1}, {-2, -1}},
                                         {{-1, 0}, {-1, 0}, {-2, 0}},
                                         {{0, -1}, {0, -1}, {0, -2}},
                                         {{-1, -1}, {-1, -1}, {-2, -2}},
                                         {{1, -1}, {1, -1}, {2, -2}}}};

/// The pixel at that offset from (x, y); none outside of the image.
std::optional<std::size_t> seen_from(const Image<std::uint32_t>& image, int x, int y, Offset offset) {
    const int u = x + offset.x, v = y + offset.y;
    if (u < 0 || v < 0 || u >= image.width) return std::nullopt;
    return image.index(u, v);
}

std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// The depth whose reciprocal is 1/a + 1/b - 1/c; a where that is none.
float on_plane(float a, float b, float c) {
    const double reciprocal = 1 / double{a} + 1 / double{b} - 1 / double{c};
    const auto depth = static_cast<float>(1 / reciprocal);
    return depth > 0 && std::isfinite(depth) ? depth : a;
}

std::uint32_t median_prediction(std::uint32_t left, std::uint32_t up, std::uint32_t up_left) {
    if (up_left >= std::max(left, up)) return std::min(left, up);
    if (up_left <= std::min(left, up)) return std::max(left, up);
    return left + up - up_left;
}

/// The bits of the depth that pixels before (x, y) lead to expect.
std::uint32_t prediction(const ImageF& depth_m, const Image<std::uint32_t>& triangles, int x, int y) {
    const auto of_same_triangle = [&](Offset offset) -> std::optional<float> {
        const auto at = seen_from(triangles, x, y, offset);
        if (!at || triangles.pixels[*at] != triangles.at(x, y)) return std::nullopt;
        return depth_m.pixels[*at];
    };
    for (const Plane& plane : kPlanes) {
        const auto a = of_same_triangle(plane.a), b = of_same_triangle(plane.b),
                   c = of_same_triangle(plane.c);
        if (a && b && c) return bits_of(on_plane(*a, *b, *c));
    }
    for (const Offset offset : kTakenFrom) {
        if (const auto same = of_same_triangle(offset)) return bits_of(*same);
    }
    const std::uint32_t left = x > 0 ? bits_of(depth_m.at(x - 1, y)) : 0;
    const std::uint32_t up = y > 0 ? bits_of(depth_m.at(x, y - 1)) : 0;
    if (x == 0 || y == 0) return x == 0 ? up : left;
    return median_prediction(left, up, bits_of(depth_m.at(x - 1, y - 1)));
}

std::string packed(const std::string& bytes) {
    return dense_text(deflated(bytes, 6, Z_FILTERED));
}

}  // namespace

std::string pack_triangles(const Image<std::uint32_t>& triangles) {
    std::string sources;
    std::vector<std::uint32_t> residuals;
    for (int y = 0; y < triangles.height; ++y) {
        for (int x = 0; x < triangles.width; ++x) {
            const std::uint32_t number = triangles.at(x, y);
            const auto source = std::ranges::find_if(kTakenFrom, [&](Offset offset) {
                const auto at = seen_from(triangles, x, y, offset);
                return at && triangles.pixels[*at] == number;
            });
            sources += static_cast<char>(source - kTakenFrom.begin());
            if (source != kTakenFrom.end()) continue;
            const std::uint32_t before = y > 0 ? triangles.at(x, y - 1) : x > 0 ? triangles.at(x - 1, y) : 0;
            residuals.push_back(number - before);
        }
    }
    return packed(sources + folded_planes(residuals));
}

std::string pack_depths(const ImageF& depth_m, const Image<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> residuals;
    residuals.reserve(depth_m.size());
    for (int y = 0; y < depth_m.height; ++y) {
        for (int x = 0; x < depth_m.width; ++x)
            residuals.push_back(bits_of(depth_m.at(x, y)) - prediction(depth_m, triangles, x, y));
    }
    return packed(folded_planes(residuals));
}

}  // namespace aoscore
