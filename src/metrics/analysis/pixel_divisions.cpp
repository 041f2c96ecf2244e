#include "metrics/analysis/pixel_divisions.h"

#include "core/threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace aoscore {
namespace {

/// The labels of bins between ascending bounds, with one bin below the first and one above the last.
std::vector<std::string> labels_between(const std::vector<double>& bounds) {
    std::vector<std::string> labels;
    labels.push_back(fmt::format("below {:.3g}", bounds.front()));
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
        labels.push_back(fmt::format("{:.3g} to {:.3g}", bounds[i], bounds[i + 1]));
    labels.push_back(fmt::format("{:.3g} or more", bounds.back()));
    return labels;
}

/// The division of the pixels by number(x, y).
template <class Number>
PixelDivision divided(const Mask& valid, const std::vector<double>& bounds, Number number) {
    PixelDivision division;
    division.bins = labels_between(bounds);
    division.bin_of = Image<std::uint8_t>(valid.width, valid.height);
    parallel_for(static_cast<std::size_t>(valid.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < valid.width; ++x) {
            const auto above = std::ranges::upper_bound(bounds, number(x, y));
            division.bin_of.at(x, y) = static_cast<std::uint8_t>(
                valid.at(x, y) != 0 ? above - bounds.begin()
                                    : static_cast<std::ptrdiff_t>(division.bins.size()));
        }
    });
    return division;
}

PixelDivision by_image(const ImageF& image, const Mask& valid, const std::vector<double>& bounds) {
    if (image.empty() || bounds.empty()) return {};
    return divided(valid, bounds, [&](int x, int y) { return double{image.at(x, y)}; });
}

PixelDivision by_edge_distance(const Mask& valid, const PixelFacts& facts) {
    return by_image(facts.edge_distance_px, valid, {2, 4, 8, 16, 32});
}

/// A halo of a near object lies on what is farther away beside it.
PixelDivision by_edge_side(const Mask& valid, const PixelFacts& facts) {
    const ImageF &edge_px = facts.edge_distance_px, &behind_px = facts.behind_edge_px;
    if (edge_px.empty() || behind_px.empty()) return {};
    constexpr float kBeside_px = 8;
    PixelDivision division;
    division.bins = {"far side", "near side", "away from edges"};
    division.bin_of = Image<std::uint8_t>(valid.width, valid.height, 3);
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid.pixels[i] == 0) continue;
        const bool is_beside = edge_px.pixels[i] < kBeside_px;
        const bool is_behind = behind_px.pixels[i] <= edge_px.pixels[i];
        division.bin_of.pixels[i] = !is_beside ? 2 : is_behind ? 0 : 1;
    }
    return division;
}

PixelDivision by_tilt(const Mask& valid, const PixelFacts& facts) {
    return by_image(facts.tilt, valid, {0.1, 0.25, 0.5, 0.75});
}

PixelDivision by_depth(const Mask& valid, const PixelFacts& facts) {
    if (facts.depth_m.empty()) return {};
    std::vector<float> depths;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid.pixels[i] != 0) depths.push_back(facts.depth_m.pixels[i]);
    }
    if (depths.empty()) return {};
    std::vector<double> bounds;
    auto from = depths.begin();
    for (const std::size_t fifth : {1U, 2U, 3U, 4U}) {
        const auto at = depths.begin() + static_cast<std::ptrdiff_t>(fifth * depths.size() / 5);
        std::nth_element(from, at, depths.end());
        bounds.push_back(double{*at});
        from = at;  // no bound before it is larger
    }
    bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
    return by_image(facts.depth_m, valid, bounds);
}

PixelDivision by_border_distance(const Mask& valid, const PixelFacts&) {
    const std::vector<double> bounds{16, 64, 128, 256};
    const auto bin_of = [&](int distance) {
        return static_cast<std::uint8_t>(std::ranges::upper_bound(bounds, double{1} * distance) -
                                         bounds.begin());
    };
    std::vector<std::uint8_t> by_column(static_cast<std::size_t>(valid.width));
    for (int x = 0; x < valid.width; ++x)
        by_column[static_cast<std::size_t>(x)] = bin_of(std::min(x, valid.width - 1 - x));
    PixelDivision division;
    division.bins = labels_between(bounds);
    division.bin_of = Image<std::uint8_t>(valid.width, valid.height);
    const auto none = static_cast<std::uint8_t>(division.bins.size());
    parallel_for(static_cast<std::size_t>(valid.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        // The smaller distance has the lower bin.
        const std::uint8_t by_row = bin_of(std::min(y, valid.height - 1 - y));
        const std::uint8_t* counts = &valid.at(0, y);
        std::uint8_t* bins = &division.bin_of.at(0, y);
        for (std::size_t x = 0; x < by_column.size(); ++x)
            bins[x] = counts[x] != 0 ? std::min(by_row, by_column[x]) : none;
    });
    return division;
}

/// One way to divide the pixels; without bins where the facts for it are not known.
struct Kind {
    std::string_view id, label, unit, meaning;
    PixelDivision (*divide)(const Mask& valid, const PixelFacts& facts);
};

constexpr Kind kKinds[] = {
    {"edge_distance", "Distance from a depth edge", "px",
     "Methods that know one depth layer err most beside a jump in depth: halos "
     "and lost occluders.",
     by_edge_distance},
    {"edge_side", "Side of a depth edge", "",
     "Within 8 pixels of a jump in depth: a halo lies on the far side, around what stands before it.",
     by_edge_side},
    {"tilt", "Tilt of the surface", "",
     "Cosine between normal and line of sight, 1 where the surface faces the "
     "camera.",
     by_tilt},
    {"depth", "View depth", "m", "Distance along the line of sight; each bin holds a fifth of the pixels.",
     by_depth},
    {"border_distance", "Distance from the image border", "px",
     "Beyond the border nothing is known to a screen-space method.", by_border_distance},
};

}  // namespace

std::vector<PixelDivision> pixel_divisions(const Mask& valid, const PixelFacts& facts) {
    std::vector<PixelDivision> divisions;
    for (const Kind& kind : kKinds) {
        PixelDivision division = kind.divide(valid, facts);
        if (division.bins.empty()) continue;
        division.id = kind.id;
        division.label = kind.label;
        division.unit = kind.unit;
        division.meaning = kind.meaning;
        divisions.push_back(std::move(division));
    }
    return divisions;
}

}  // namespace aoscore
