#include "core/threads.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures.h"
#include "metrics/measures/flip_colour.h"
#include "metrics/measures/flip_filter.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/power.h"
#include "metrics/measures/srgb_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

// After Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild,
// "FLIP: A Difference Evaluator for Alternating Images", 2020, for gray images.
namespace aoscore {
namespace {

constexpr int kMargin_px = FlipFilter::kMargin_px;
// Low enough for what is kept of a tile's rows to stay in cache, high enough for margins to cost little.
constexpr int kTileWidth_px = 256, kTileHeight_px = 128;

struct Area {
    int left, top, width, height;
};

std::vector<Area> tiles_of(int width, int height) {
    std::vector<Area> tiles;
    for (int y = 0; y < height; y += kTileHeight_px) {
        for (int x = 0; x < width; x += kTileWidth_px)
            tiles.push_back({x, y, std::min(kTileWidth_px, width - x), std::min(kTileHeight_px, height - y)});
    }
    return tiles;
}

/// FLIP's map over a part of the image, one row after the other.
class Tile {
  public:
    Tile(const MetricInput& input, const Area& area)
        : input_(input),
          area_(area),
          truth_(static_cast<std::size_t>(area.width)),
          test_(truth_),
          valid_(truth_),
          row_(static_cast<std::size_t>(area.width + 2 * kMargin_px)),
          map_(static_cast<std::size_t>(area.width)),
          exponents_(map_.size()),
          has_invalid_(has_invalid()) {}

    /// Adds the map over the valid pixels, by block.
    void add_to(std::vector<double>& sums, const BlockGrid& grid) {
        for (int y = -kMargin_px; y < area_.height + kMargin_px; ++y) {
            push_row(std::clamp(area_.top + y, 0, input_.valid.height - 1));
            if (y < kMargin_px) continue;
            find_map();
            add_row(area_.top + y - kMargin_px, sums, grid);
        }
    }

  private:
    const std::uint8_t* valid_row(int y) const { return &input_.valid.at(0, y); }

    bool has_invalid() const {
        const int left = std::max(area_.left - kMargin_px, 0);
        const int right = std::min(area_.left + area_.width + kMargin_px, input_.valid.width);
        const int top = std::max(area_.top - kMargin_px, 0);
        const int bottom = std::min(area_.top + area_.height + kMargin_px, input_.valid.height);
        for (int y = top; y < bottom; ++y) {
            const std::uint8_t* row = valid_row(y);
            if (std::find(row + left, row + right, 0) != row + right) return true;
        }
        return false;
    }

    /// The image's row with a margin: beyond the image its outermost pixels are repeated.
    template <class F>
    void read_row(F value_at) {
        const int last = input_.valid.width - 1;
        for (std::size_t i = 0; i < row_.size(); ++i)
            row_[i] = value_at(std::clamp(area_.left - kMargin_px + static_cast<int>(i), 0, last));
    }

    void push_row(int y) {
        const std::uint8_t* valid = valid_row(y);
        for (auto [image, filter] : {std::pair(&input_.truth, &truth_), std::pair(&input_.test, &test_)}) {
            const float* values = &image->at(0, y);
            // Values may be NaN where they are invalid.
            read_row([&](int x) { return valid[x] == 0 ? 0.0 : std::clamp(double{values[x]}, 0.0, 1.0); });
            take_srgb_off(row_);
            filter->push(row_);
        }
        if (!has_invalid_) return;
        read_row([&](int x) { return valid[x] == 0 ? 0.0 : 1.0; });
        valid_.push(row_);
    }

    /// Takes invalid pixels out of what was filtered as 0 there: the mean is over the valid ones, and in a
    /// derivative the value of the pixel itself stands for an invalid one, which therefore has no part in it.
    void without_invalid(FlipFilter& image) {
        using enum FlipFilter::Response;
        const std::span<double> seen = image[kSeen], weights = valid_[kSeen];
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (weights[i] > 0) seen[i] /= weights[i];
        }
        const std::span<double> self = image[kSelf];
        for (const auto derivative : {kEdgeX, kEdgeY, kPointX, kPointY}) {
            const std::span<double> values = image[derivative], of_valid = valid_[derivative];
            for (std::size_t i = 0; i < values.size(); ++i) values[i] -= self[i] * of_valid[i];
        }
    }

    /// How much longer the derivative is in one image than in the other.
    double length_difference(FlipFilter::Response in_x, FlipFilter::Response in_y, std::size_t i) {
        const auto length = [&](FlipFilter& image) {
            return std::sqrt(image[in_x][i] * image[in_x][i] + image[in_y][i] * image[in_y][i]);
        };
        return std::abs(length(truth_) - length(test_));
    }

    void find_map() {
        using enum FlipFilter::Response;
        truth_.respond();
        test_.respond();
        if (has_invalid_) {
            valid_.respond();
            without_invalid(truth_);
            without_invalid(test_);
        }
        for (std::size_t i = 0; i < map_.size(); ++i) {
            const double feature =
                std::max(length_difference(kEdgeX, kEdgeY, i), length_difference(kPointX, kPointY, i));
            exponents_[i] = std::max(1 - std::sqrt(feature / std::numbers::sqrt2), 0.0);
        }
        std::ranges::copy(truth_[kSeen], map_.begin());
        flip_color_differences(map_, test_[kSeen]);
        raise(map_, exponents_);
    }

    void add_row(int y, std::vector<double>& sums, const BlockGrid& grid) const {
        const std::uint8_t* valid = valid_row(y);
        const int right = area_.left + area_.width;
        grid.for_each_piece(y, area_.left, right, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) {
                if (valid[x] != 0) sums[block] += map_[static_cast<std::size_t>(x - area_.left)];
            }
        });
    }

    const MetricInput& input_;
    Area area_;
    FlipFilter truth_, test_, valid_;
    std::vector<double> row_;              ///< with margins
    std::vector<double> map_, exponents_;  ///< of one row
    bool has_invalid_;                     ///< here or in the margins
};

}  // namespace

MetricValue measure::flip(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    if (!mse) return undefined(kNoValidPixel);
    if (!std::isfinite(*mse)) return undefined(kNotFinite);  // Before infinity is clamped to 1.
    const BlockGrid grid(input.truth.width, input.truth.height);
    const std::vector<Area> tiles = tiles_of(input.truth.width, input.truth.height);
    std::vector<std::vector<double>> of_tiles(tiles.size(), std::vector<double>(grid.size()));
    parallel_for(tiles.size(), [&](std::size_t t) { Tile(input, tiles[t]).add_to(of_tiles[t], grid); });
    std::vector<double> sums;
    for (const std::vector<double>& tile : of_tiles) add_sums(sums, tile);
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    const auto count = static_cast<double>(
        std::ranges::count_if(input.valid.pixels, [](std::uint8_t valid) { return valid != 0; }));
    if (input.maps != nullptr) input.maps->flip_sums = std::move(sums);
    return defined(sum / count);
}

}  // namespace aoscore
