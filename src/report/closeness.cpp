#include "report/closeness.h"

#include <algorithm>
#include <cassert>
#include <random>

namespace aoscore {
namespace {

constexpr int kBlocksAcross = 24;
constexpr int kResamples = 2000;

}  // namespace

BlockErrors block_errors(const ImageF& truth, const ImageF& test, const Mask& valid) {
    const int side_px = std::max(1, truth.width / kBlocksAcross);
    const int across = (truth.width + side_px - 1) / side_px;
    const int down = (truth.height + side_px - 1) / side_px;
    BlockErrors blocks;
    blocks.squared_sums.assign(static_cast<std::size_t>(across * down), 0.0);
    blocks.counts = blocks.squared_sums;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const std::size_t i = truth.index(x, y);
            if (valid.pixels[i] == 0) continue;
            const double error = double{test.pixels[i]} - double{truth.pixels[i]};
            const auto block = static_cast<std::size_t>(y / side_px * across + x / side_px);
            blocks.squared_sums[block] += error * error;
            blocks.counts[block] += 1;
        }
    }
    return blocks;
}

Interval mse_difference(const BlockErrors& a, const BlockErrors& b, std::uint64_t seed) {
    const std::size_t blocks = a.counts.size();
    assert(blocks == b.counts.size());
    if (blocks == 0) return {};
    std::mt19937_64 random(seed);
    std::vector<double> differences;
    differences.reserve(kResamples);
    for (int i = 0; i < kResamples; ++i) {
        double sum_a = 0, sum_b = 0, count_a = 0, count_b = 0;
        for (std::size_t k = 0; k < blocks; ++k) {
            const std::size_t drawn = random() % blocks;
            sum_a += a.squared_sums[drawn];
            sum_b += b.squared_sums[drawn];
            count_a += a.counts[drawn];
            count_b += b.counts[drawn];
        }
        if (count_a > 0 && count_b > 0) differences.push_back(sum_a / count_a - sum_b / count_b);
    }
    if (differences.empty()) return {};
    std::sort(differences.begin(), differences.end());
    const auto quantile = [&](double q) {
        return differences[static_cast<std::size_t>(q * static_cast<double>(differences.size() - 1) + 0.5)];
    };
    return {quantile(0.025), quantile(0.975)};
}

std::string ranking_metric(const std::vector<const CellRecord*>& cells) {
    const bool debiased = std::all_of(cells.begin(), cells.end(), [](const CellRecord* cell) {
        return !cell->error.empty() || ranked_value(*cell, "rmse_debiased").has_value();
    });
    return debiased ? "rmse_debiased" : "rmse";
}

std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric) {
    if (!cell.error.empty()) return std::nullopt;
    const auto found = cell.ranked.find(metric);
    return found == cell.ranked.end() ? std::nullopt : found->second.value;
}

}  // namespace aoscore
