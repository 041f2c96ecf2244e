#include "compare/tried_readings.h"

#include "metrics/measures/bands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aoscore {
namespace {

void invert(std::span<double> values) {
    for (double& value : values) value = 1 - value;
}

/// A row of the test as it would be read, with the pixels that then count.
class ReadRow {
  public:
    ReadRow(const VisibilityFile& truth, const VisibilityFile& test, const Mask& valid)
        : truth_(truth), test_(test), valid_(valid), values_(width()), counts_(width()), changed_(width()) {}

    void read(const Reading& reading, int y) {
        const std::span<const float> values = row_of(test_.visibility, reading.turned, y);
        const std::span<const std::uint8_t> counts =
            reading.turned.upright() ? row_of(valid_, {}, y) : row_of(test_.mask, reading.turned, y);
        if (reading.turned.mirrored) {
            std::ranges::reverse_copy(values, values_.begin());
            std::ranges::reverse_copy(counts, counts_.begin());
        } else {
            std::ranges::copy(values, values_.begin());
            std::ranges::copy(counts, counts_.begin());
        }
        if (!reading.turned.upright()) {
            const std::span<const std::uint8_t> of_truth = row_of(truth_.mask, {}, y);
            for (std::size_t x = 0; x < width(); ++x) counts_[x] &= of_truth[x];
        }
        if (reading.inverted) change(invert);
        if (reading.curve == nullptr) return;
        change([&](std::span<double> changed) {
            if (reading.curve_of_occlusion) invert(changed);
            reading.curve(changed);
            if (reading.curve_of_occlusion) invert(changed);
        });
    }

    std::span<const float> truth(int y) const { return row_of(truth_.visibility, {}, y); }
    std::span<const float> values() const { return values_; }
    std::span<const std::uint8_t> counts() const { return counts_; }

  private:
    std::size_t width() const { return static_cast<std::size_t>(valid_.width); }

    template <class T>
    static std::span<const T> row_of(const Image<T>& image, const Orientation& turned, int y) {
        return {&image.at(0, turned.turned_over ? image.height - 1 - y : y),
                static_cast<std::size_t>(image.width)};
    }

    /// Changes the values, clamped to [0,1]; NaN stays.
    template <class Change>
    void change(Change apply) {
        for (std::size_t x = 0; x < width(); ++x) changed_[x] = std::clamp(double{values_[x]}, 0.0, 1.0);
        apply(std::span(changed_));
        for (std::size_t x = 0; x < width(); ++x) {
            if (!std::isnan(values_[x])) values_[x] = static_cast<float>(changed_[x]);
        }
    }

    const VisibilityFile &truth_, &test_;
    const Mask& valid_;
    std::vector<float> values_;
    std::vector<std::uint8_t> counts_;
    std::vector<double> changed_;
};

}  // namespace

std::vector<Tried> tried_readings(const VisibilityFile& truth, const VisibilityFile& test, const Mask& valid,
                                  std::span<const Reading> readings) {
    std::vector<std::vector<LikenessSums>> bands(band_count(valid.height),
                                                 std::vector<LikenessSums>(readings.size()));
    for_each_band(valid.height, [&](std::size_t band, int first_row, int rows) {
        ReadRow row(truth, test, valid);
        for (int y = first_row; y < first_row + rows; ++y) {
            for (std::size_t r = 0; r < readings.size(); ++r) {
                row.read(readings[r], y);
                bands[band][r].add(row.truth(y), row.values(), row.counts());
            }
        }
    });
    std::vector<Tried> results;
    for (std::size_t r = 0; r < readings.size(); ++r) {
        LikenessSums all;
        for (const std::vector<LikenessSums>& band : bands) all.add(band[r]);
        results.push_back({readings[r], all.likeness()});
    }
    return results;
}

}  // namespace aoscore
