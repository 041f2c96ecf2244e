#include "metrics/analysis/splits.h"

#include "core/threads.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace aoscore {
namespace {

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

/// One row of an image's errors, which are divided among bins. Invalid pixels may have any value.
struct ErrorRow {
    std::size_t first;  ///< index of its first pixel
    std::vector<double> errors, variances;
};

ErrorRow error_row(const MetricInput& input, int y) {
    const std::size_t first = input.valid.index(0, y);
    ErrorRow row{first, std::vector<double>(static_cast<std::size_t>(input.valid.width)), {}};
    row.variances = row.errors;
    for (std::size_t x = 0; x < row.errors.size(); ++x) {
        const std::size_t i = first + x;
        row.errors[x] = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        if (knows_noise(input)) row.variances[x] = noise_variance(input, i);
    }
    return row;
}

/// Adds a row to `sums`, which has an entry for each bin and an unused last one; `bins` are those of the
/// row's pixels.
void add_by_bin(const ErrorRow& row, const std::uint8_t* bins, Sums* sums) {
    for (std::size_t x = 0; x < row.errors.size();) {
        const std::uint8_t bin = bins[x];
        Sums run = sums[bin];  // Neighbours mostly lie in one bin.
        for (; x < row.errors.size() && bins[x] == bin; ++x) run.add(1, row.errors[x], row.variances[x]);
        sums[bin] = run;
    }
}

constexpr std::size_t kSigns = 3;

void add_by_sign(const MetricInput& input, const ErrorRow& row, Sums* sums) {
    std::vector<std::uint8_t> bins(row.errors.size());
    for (std::size_t x = 0; x < bins.size(); ++x) {
        const float truth = input.truth.pixels[row.first + x], test = input.test.pixels[row.first + x];
        const int sign = test < truth ? 0 : test > truth ? 2 : 1;
        bins[x] = static_cast<std::uint8_t>(input.valid.pixels[row.first + x] != 0 ? sign : int{kSigns});
    }
    add_by_bin(row, bins.data(), sums);
}

/// Divides a row's pixels among the causes of their occlusion; the first bin is for pixels without any.
void add_by_cause(const MetricInput& input, const ErrorRow& row, const std::vector<PixelFacts::Cause>& causes,
                  Sums* sums) {
    std::vector<double> parts(causes.size());
    for (std::size_t x = 0; x < row.errors.size(); ++x) {
        const std::size_t pixel = row.first + x;
        if (input.valid.pixels[pixel] == 0) continue;
        double occlusion = 0;
        for (std::size_t c = 0; c < causes.size(); ++c)
            occlusion += parts[c] = std::max(double{causes[c].occlusion->pixels[pixel]}, 0.0);
        if (occlusion <= 0) {
            sums[0].add(1, row.errors[x], row.variances[x]);
            continue;
        }
        for (std::size_t c = 0; c < causes.size(); ++c) {
            if (parts[c] > 0) sums[c + 1].add(parts[c] / occlusion, row.errors[x], row.variances[x]);
        }
    }
}

/// All ways to divide the pixels of an image, and the sums of their bins.
class Splitter {
  public:
    Splitter(const MetricInput& input, const PixelFacts& facts, const std::vector<PixelDivision>& divisions)
        : input_(input), facts_(facts), divisions_(divisions) {
        splits_.push_back({"sign", "Sign of the error", "",
                           "Too dark is false occlusion, too bright is missing occlusion.",
                           bins_named({"darker than the truth", "equal", "brighter than the truth"})});
        if (!facts.causes.empty()) {
            std::vector<std::string> names{"nothing occludes"};
            for (const PixelFacts::Cause& cause : facts.causes) names.push_back(cause.name);
            splits_.push_back({"cause", "What occludes", "",
                               "By where the truth's nearest occluders lie for the "
                               "camera; a pixel is divided "
                               "among them.",
                               bins_named(names)});
        }
        for (const PixelDivision& division : divisions)
            splits_.push_back({std::string(division.id), std::string(division.label),
                               std::string(division.unit), std::string(division.meaning),
                               bins_named(division.bins)});
    }

    std::vector<Split> measured() {
        const std::vector<Sums> sums = all_sums();
        const Sums* of_split = sums.data();
        for (Split& split : splits_) {
            fill(split, of_split);
            of_split += split.bins.size() + 1;
        }
        return std::move(splits_);
    }

  private:
    static std::vector<SplitBin> bins_named(const std::vector<std::string>& names) {
        std::vector<SplitBin> bins(names.size());
        for (std::size_t b = 0; b < bins.size(); ++b) bins[b].label = names[b];
        return bins;
    }

    /// Adds a row to the sums of all splits, one after the other, each with its bins and an unused last
    /// entry.
    void add_row(int y, Sums* sums) const {
        const ErrorRow row = error_row(input_, y);
        add_by_sign(input_, row, sums);
        sums += kSigns + 1;
        if (!facts_.causes.empty()) {
            add_by_cause(input_, row, facts_.causes, sums);
            sums += facts_.causes.size() + 2;
        }
        for (const PixelDivision& division : divisions_) {
            add_by_bin(row, &division.bin_of.at(0, y), sums);
            sums += division.bins.size() + 1;
        }
    }

    /// The sums of all rows, added in order.
    std::vector<Sums> all_sums() const {
        std::size_t bins = 0;
        for (const Split& split : splits_) bins += split.bins.size() + 1;
        std::vector<std::vector<Sums>> rows(static_cast<std::size_t>(input_.truth.height),
                                            std::vector<Sums>(bins));
        parallel_for(rows.size(), [&](std::size_t y) { add_row(static_cast<int>(y), rows[y].data()); });
        std::vector<Sums> all(bins);
        for (const std::vector<Sums>& row : rows) {
            for (std::size_t b = 0; b < bins; ++b) all[b].add(row[b]);
        }
        return all;
    }

    void fill(Split& split, const Sums* sums) const {
        Sums all;
        for (std::size_t b = 0; b < split.bins.size(); ++b) all.add(sums[b]);
        for (std::size_t b = 0; b < split.bins.size(); ++b) {
            SplitBin& bin = split.bins[b];
            bin.share = sums[b].weight / all.weight;
            bin.error_share = all.squared > 0 ? sums[b].squared / all.squared : 0.0;
            if (!(sums[b].weight > 0)) continue;
            bin.rmse = std::sqrt(sums[b].squared / sums[b].weight);
            bin.bias = sums[b].signed_sum / sums[b].weight;
            if (knows_noise(input_)) bin.noise_rmse = std::sqrt(sums[b].variance / sums[b].weight);
        }
    }

    const MetricInput& input_;
    const PixelFacts& facts_;
    const std::vector<PixelDivision>& divisions_;
    std::vector<Split> splits_;
};

}  // namespace

std::vector<Split> error_splits(const MetricInput& input, const PixelFacts& facts,
                                const std::vector<PixelDivision>& divisions) {
    if (!has_valid_pixel(input)) return {};
    return Splitter(input, facts, divisions).measured();
}

std::vector<Split> error_splits(const MetricInput& input, const PixelFacts& facts) {
    require_one_size(input);
    return error_splits(input, facts, pixel_divisions(input.valid, facts));
}

}  // namespace aoscore
