#include "metrics/analysis/splits.h"

#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace aoscore {
namespace {

/// Which bins a pixel belongs to: weights, one a bin, 0 on entry, that add up to 1 for every pixel.
struct Division {
    std::vector<std::string> labels;
    std::function<void(std::size_t pixel, std::span<double> weights)> weigh;
};

/// Bins between the bounds, which are in ascending order, one below the first and one above the last.
Division by_number(const std::vector<double>& bounds, std::function<double(std::size_t)> number) {
    Division division;
    division.labels.push_back(fmt::format("below {:.3g}", bounds.front()));
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
        division.labels.push_back(fmt::format("{:.3g} to {:.3g}", bounds[i], bounds[i + 1]));
    division.labels.push_back(fmt::format("{:.3g} or more", bounds.back()));
    division.weigh = [bounds, number = std::move(number)](std::size_t pixel, std::span<double> weights) {
        const auto above = std::ranges::upper_bound(bounds, number(pixel));
        weights[static_cast<std::size_t>(above - bounds.begin())] = 1;
    };
    return division;
}

std::optional<Division> by_sign(const MetricInput& input, const PixelFacts&) {
    return Division{{"darker than the truth", "equal", "brighter than the truth"},
                    [&input](std::size_t i, std::span<double> weights) {
                        const float truth = input.truth.pixels[i], test = input.test.pixels[i];
                        weights[test < truth ? 0 : test > truth ? 2 : 1] = 1;
                    }};
}

std::optional<Division> by_cause(const MetricInput&, const PixelFacts& facts) {
    if (facts.causes.empty()) return std::nullopt;
    Division division;
    division.labels.push_back("nothing occludes");
    for (const PixelFacts::Cause& cause : facts.causes) division.labels.push_back(cause.name);
    division.weigh = [&causes = facts.causes](std::size_t pixel, std::span<double> weights) {
        double occlusion = 0;
        for (std::size_t c = 0; c < causes.size(); ++c)
            occlusion += weights[c + 1] = std::max(double{causes[c].occlusion->pixels[pixel]}, 0.0);
        if (occlusion <= 0) {
            weights[0] = 1;
            return;
        }
        for (double& weight : weights) weight /= occlusion;
    };
    return division;
}

std::optional<Division> by_image(const ImageF& image, const std::vector<double>& bounds) {
    if (image.empty() || bounds.empty()) return std::nullopt;
    return by_number(bounds, [&image](std::size_t i) { return double{image.pixels[i]}; });
}

std::optional<Division> by_edge_distance(const MetricInput&, const PixelFacts& facts) {
    return by_image(facts.edge_distance_px, {2, 4, 8, 16, 32});
}

std::optional<Division> by_tilt(const MetricInput&, const PixelFacts& facts) {
    return by_image(facts.tilt, {0.1, 0.25, 0.5, 0.75});
}

std::optional<Division> by_depth(const MetricInput& input, const PixelFacts& facts) {
    if (facts.depth_m.empty()) return std::nullopt;
    std::vector<float> depths;
    for (std::size_t i = 0; i < input.valid.size(); ++i) {
        if (input.valid.pixels[i] != 0) depths.push_back(facts.depth_m.pixels[i]);
    }
    std::vector<double> bounds;
    for (const std::size_t fifth : {1U, 2U, 3U, 4U}) {
        const auto at = depths.begin() + static_cast<std::ptrdiff_t>(fifth * depths.size() / 5);
        std::nth_element(depths.begin(), at, depths.end());
        bounds.push_back(double{*at});
    }
    bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
    return by_image(facts.depth_m, bounds);
}

std::optional<Division> by_border(const MetricInput& input, const PixelFacts&) {
    const int width = input.truth.width, height = input.truth.height;
    return by_number({16, 64, 128, 256}, [=](std::size_t i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        return double{1} * std::min({x, y, width - 1 - x, height - 1 - y});
    });
}

/// One way to divide the pixels; empty where the facts for it are not known.
struct Kind {
    const char *id, *label, *unit, *meaning;
    std::optional<Division> (*divide)(const MetricInput& input, const PixelFacts& facts);
};

constexpr Kind kKinds[] = {
    {"sign", "Sign of the error", "", "Too dark is false occlusion, too bright is missing occlusion.",
     by_sign},
    {"cause", "What occludes", "",
     "By where the truth's nearest occluders lie for the camera; a pixel is divided among them.", by_cause},
    {"edge_distance", "Distance from a depth edge", "px",
     "Methods that know one depth layer err most beside a jump in depth: halos and lost occluders.",
     by_edge_distance},
    {"tilt", "Tilt of the surface", "",
     "Cosine between normal and line of sight, 1 where the surface faces the camera.", by_tilt},
    {"depth", "View depth", "m", "Distance along the line of sight; each bin holds a fifth of the pixels.",
     by_depth},
    {"border_distance", "Distance from the image border", "px",
     "Beyond the border nothing is known to a screen-space method.", by_border},
};

struct Sums {
    double weight = 0, squared = 0, signed_sum = 0, variance = 0;
    void add(double w, double error, double noise_variance) {
        weight += w;
        squared += w * error * error;
        signed_sum += w * error;
        variance += w * noise_variance;
    }
    void add(const Sums& other) {
        weight += other.weight;
        squared += other.squared;
        signed_sum += other.signed_sum;
        variance += other.variance;
    }
};

/// Sums of each bin, row by row and then in order.
std::vector<Sums> bin_sums(const MetricInput& input, const Division& division) {
    const std::size_t bins = division.labels.size();
    const auto width = static_cast<std::size_t>(input.truth.width);
    std::vector<std::vector<Sums>> rows(static_cast<std::size_t>(input.truth.height),
                                        std::vector<Sums>(bins));
    parallel_for(rows.size(), [&](std::size_t y) {
        std::vector<double> weights(bins);
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            if (input.valid.pixels[i] == 0) continue;
            std::ranges::fill(weights, 0.0);
            division.weigh(i, weights);
            const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
            const double variance = knows_noise(input) ? noise_variance(input, i) : 0.0;
            for (std::size_t b = 0; b < bins; ++b) {
                if (weights[b] > 0) rows[y][b].add(weights[b], error, variance);
            }
        }
    });
    std::vector<Sums> all(bins);
    for (const std::vector<Sums>& row : rows) {
        for (std::size_t b = 0; b < bins; ++b) all[b].add(row[b]);
    }
    return all;
}

std::vector<SplitBin> bins_of(const MetricInput& input, const Division& division) {
    const std::vector<Sums> sums = bin_sums(input, division);
    Sums all;
    for (const Sums& bin : sums) all.add(bin);
    std::vector<SplitBin> bins;
    for (std::size_t b = 0; b < sums.size(); ++b) {
        SplitBin bin;
        bin.label = division.labels[b];
        bin.share = sums[b].weight / all.weight;
        bin.error_share = all.squared > 0 ? sums[b].squared / all.squared : 0.0;
        if (sums[b].weight > 0) {
            bin.rmse = std::sqrt(sums[b].squared / sums[b].weight);
            bin.bias = sums[b].signed_sum / sums[b].weight;
            if (knows_noise(input)) bin.noise_rmse = std::sqrt(sums[b].variance / sums[b].weight);
        }
        bins.push_back(std::move(bin));
    }
    return bins;
}

}  // namespace

std::vector<Split> error_splits(const MetricInput& input, const PixelFacts& facts) {
    require_one_size(input);
    if (std::ranges::find(input.valid.pixels, 1) == input.valid.pixels.end()) return {};
    std::vector<Split> splits;
    for (const Kind& kind : kKinds) {
        if (const std::optional<Division> division = kind.divide(input, facts)) {
            splits.push_back({kind.id, kind.label, kind.unit, kind.meaning, bins_of(input, *division)});
        }
    }
    return splits;
}

}  // namespace aoscore
