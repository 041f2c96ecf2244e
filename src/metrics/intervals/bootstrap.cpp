#include "metrics/intervals/bootstrap.h"

#include "core/error.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/intervals/block_sums.h"
#include "metrics/intervals/drawn_sums.h"
#include "metrics/intervals/over_views.h"
#include "metrics/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace aoscore {

namespace {

constexpr int kResamples = 2000;
constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

std::size_t blocks_with(const std::vector<DrawnSums>& blocks, double DrawnSums::*pixels) {
    return static_cast<std::size_t>(
        std::ranges::count_if(blocks, [&](const DrawnSums& block) { return block.*pixels > 0; }));
}

/// Whether too few blocks hold pixels of a kind to tell an interval.
bool is_small(const std::vector<DrawnSums>& blocks, double DrawnSums::*pixels) {
    return blocks_with(blocks, pixels) < kFewestBlocks;
}

/// An image from which blocks are drawn. Sums that it lacks are NaN; it has no blocks where they are too few.
class Urn {
  public:
    explicit Urn(const BlockErrors& image) : blocks_(sums_of_blocks(image)), maps_(image.maps) {
        if (is_small(blocks_, &DrawnSums::count)) blocks_.clear();
        // The index counts inside the border alone.
        if (!is_small(blocks_, &DrawnSums::ssim_weight)) return;
        for (DrawnSums& block : blocks_) block.ssim = kNotThere;
    }

    /// Squares for MS-SSIM come from a generator of their own, since they differ from the blocks.
    DrawnSums draw(std::mt19937_64& random, std::mt19937_64& random_squares) const {
        DrawnSums sums;
        for (std::size_t k = 0; k < blocks_.size(); ++k) sums += blocks_[random() % blocks_.size()];
        sums.ms_ssim = draw_ms_ssim(random_squares);
        return sums;
    }

  private:
    double draw_ms_ssim(std::mt19937_64& random) const {
        if (!maps_.ms_ssim) return kNotThere;
        const std::vector<double>& influences = maps_.ms_ssim_influences;
        double moved = 0;
        for (std::size_t k = 0; k < influences.size(); ++k) moved += influences[random() % influences.size()];
        // The change is of first order only, but the index cannot exceed 1.
        return std::min(1.0, *maps_.ms_ssim * std::exp(moved));
    }

    std::vector<DrawnSums> blocks_;
    const MapSums& maps_;
};

struct Statistic {
    std::string measure;
    double (*value)(const DrawnSums& sums);
};

/// The statistics of the metrics that have one, then of the masks' areas.
const std::vector<Statistic>& statistics() {
    static const std::vector<Statistic> list = [] {
        std::vector<Statistic> rows;
        for (const Metric& metric : metrics()) {
            if (metric.resampled != nullptr) rows.push_back({std::string(metric.id), metric.resampled});
        }
        for (const MaskArea& area : mask_areas()) rows.push_back({std::string(area.id), area.resampled});
        return rows;
    }();
    return list;
}

const Statistic& statistic(const std::string& measure) {
    const auto found = std::ranges::find(statistics(), measure, &Statistic::measure);
    if (found == statistics().end()) throw internal_error("no bootstrap of " + measure);
    return *found;
}

/// Values of several statistics from the same draws.
std::vector<std::vector<double>> resampled_together(std::span<const Statistic> rows, BootstrapImages images,
                                                    std::uint64_t seed) {
    std::vector<Urn> urns;
    for (const BlockErrors* image : images) urns.emplace_back(*image);
    std::vector<std::vector<double>> values(rows.size());
    std::vector<std::vector<double>> of_views(rows.size(), std::vector<double>(urns.size()));
    std::mt19937_64 random(seed), random_squares(seed);
    for (int i = 0; i < kResamples; ++i) {
        for (std::size_t k = 0; k < urns.size(); ++k) {
            const Urn& urn = urns[urns.size() == 1 ? 0 : random() % urns.size()];
            const DrawnSums drawn = urn.draw(random, random_squares);
            for (std::size_t s = 0; s < rows.size(); ++s)
                of_views[s][k] = drawn.count > 0 ? rows[s].value(drawn) : kNotThere;
        }
        for (std::size_t s = 0; s < rows.size(); ++s)
            values[s].push_back(measure_over_views(rows[s].measure, of_views[s]));
    }
    return values;
}

}  // namespace

const std::vector<std::string>& bootstrap_measures() {
    static const std::vector<std::string> ids = [] {
        std::vector<std::string> list;
        for (const Statistic& row : statistics()) list.emplace_back(row.measure);
        return list;
    }();
    return ids;
}

bool can_be_resampled(const std::string& measure) {
    return std::ranges::find(bootstrap_measures(), measure) != bootstrap_measures().end();
}

std::vector<double> resampled(const std::string& measure, BootstrapImages images, std::uint64_t seed) {
    return resampled_together({&statistic(measure), 1}, images, seed).front();
}

std::string why_no_intervals(const BlockErrors& image) {
    const std::size_t blocks = blocks_with(sums_of_blocks(image), &DrawnSums::count);
    if (blocks >= kFewestBlocks) return {};
    return fmt::format(
        "no number has an interval: the valid pixels lie in {} of the picture's blocks, and "
        "an interval takes at least {}",
        blocks, kFewestBlocks);
}

double value_of_blocks(const std::string& measure, const BlockErrors& image) {
    DrawnSums all;
    for (const DrawnSums& block : sums_of_blocks(image)) all += block;
    all.ms_ssim = image.maps.ms_ssim.value_or(kNotThere);
    return all.count > 0 ? statistic(measure).value(all) : kNotThere;
}

std::optional<Interval> confidence_interval(std::vector<double> values) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) return std::nullopt;
    std::ranges::sort(values);
    if (!std::isfinite(values.front()) || !std::isfinite(values.back())) return std::nullopt;
    const auto quantile = [&](double q) {
        return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
    };
    const Interval interval{quantile(0.025), quantile(0.975)};
    return interval.low < interval.high ? std::optional(interval) : std::nullopt;
}

std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) throw internal_error("resampled values that do not pair");
    std::vector<double> differences(a.size());
    std::ranges::transform(a, b, differences.begin(), std::minus<>());
    return confidence_interval(std::move(differences));
}

std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed) {
    const std::vector<std::vector<double>> values = resampled_together(statistics(), images, seed);
    std::map<std::string, Interval> intervals;
    for (std::size_t s = 0; s < values.size(); ++s) {
        if (const auto interval = confidence_interval(values[s]))
            intervals[statistics()[s].measure] = *interval;
    }
    return intervals;
}

}  // namespace aoscore
