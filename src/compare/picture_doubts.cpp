#include "compare/picture_doubts.h"

#include "compare/tried_readings.h"
#include "metrics/measures/bands.h"
#include "metrics/measures/srgb_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace aoscore {
namespace {

// Rounding of half floats and ringing of filters stay below this.
constexpr float kBeyondNoise = 0.002F;
// Another reading is suggested where it leaves less than this share of the variance of the truth that the
// given reading leaves unexplained. Of 240 pictures of this program's methods on five scenes (correlation .03
// to .99), none came below .99 when it was turned and none below .72 when its coding was changed, while a
// limit of .95 detected 82 in a hundred that were upside down. A wrong coding is detected only in pictures
// close to the truth: it hardly changes the correlation of others.
constexpr double kTurnedGain = 0.95, kCodedGain = 0.7;
// Below this correlation a picture may be of another camera, or no ambient occlusion at all. Of those 240,
// four of one method came below.
constexpr double kHardlyAlike = 0.1;

/// The numbers of values that no visibility has.
struct RangeCounts {
    std::size_t below = 0, above = 0, count = 0;
    float least = 0, most = 1;

    void add(float value) {
        ++count;
        below += value < -kBeyondNoise ? 1 : 0;
        above += value > 1 + kBeyondNoise ? 1 : 0;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    void add(const RangeCounts& other) {
        below += other.below;
        above += other.above;
        count += other.count;
        least = std::min(least, other.least);
        most = std::max(most, other.most);
    }
};

class Doubts {
  public:
    Doubts(const VisibilityFile& truth, const VisibilityFile& test, const Mask& valid,
           const VisibilityReading& reading)
        : truth_(truth), test_(test), valid_(valid), reading_(reading) {}

    void add_range(const ImageF& image, const char* name) {
        std::vector<RangeCounts> bands(band_count(image.height));
        for_each_band(image.height, [&](std::size_t band, int first_row, int rows) {
            const std::size_t first = image.index(0, first_row);
            const std::size_t end =
                first + static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.width);
            RangeCounts counts;
            for (std::size_t i = first; i < end; ++i) {
                const float value = image.pixels[i];
                if (valid_.pixels[i] != 0 && std::isfinite(value)) counts.add(value);
            }
            bands[band] = counts;
        });
        RangeCounts all;
        for (const RangeCounts& band : bands) all.add(band);
        if (all.below + all.above == 0) return;
        say("{}: of {} pixels {} are below 0 and {} above 1 (from {:.4g} to {:.4g}), which no visibility is",
            name, all.count, all.below, all.above, all.least, all.most);
    }

    void add_readings(bool turned_in_whole) {
        const Tried best = best_orientation(turned_in_whole);
        if (!best.likeness) return;
        const bool inverted = best.likeness->correlation < -kHardlyAlike;
        if (inverted) {
            say("the picture runs against the truth (correlation {:.2f}): it may hold {}; {} --invert",
                best.likeness->correlation, reading_.invert ? "visibility" : "occlusion",
                reading_.invert ? "leave out" : "try");
        }
        if (std::abs(best.likeness->correlation) < kHardlyAlike) {
            say("the picture hardly follows the truth (correlation {:.2f}): is it ambient occlusion, of the "
                "same view?",
                best.likeness->correlation);
        } else {
            Reading reading = best.reading;
            reading.inverted = inverted;
            reading.curve_of_occlusion = reading_.invert != inverted;
            add_coding(reading);
        }
    }

    std::vector<std::string> said;

  private:
    template <class... Parts>
    void say(fmt::format_string<Parts...> text, Parts&&... parts) {
        said.push_back(fmt::format(text, std::forward<Parts>(parts)...));
    }

    /// The reading as given, or turned where that is better by far; without a likeness where the given one
    /// has none.
    Tried best_orientation(bool turned_in_whole) {
        struct Turn {
            const char* meaning;
            const char* options;
        };
        static constexpr Reading kReadings[] = {
            {}, {{false, false, true}}, {{false, true, false}}, {{false, true, true}}};
        static constexpr Turn kTurns[] = {{"upside down", "--flip"},
                                          {"mirrored", "--mirror"},
                                          {"upside down and mirrored", "--flip and --mirror"}};
        const auto share = [](const Tried& v) {
            return v.likeness ? 1 - v.likeness->correlation * v.likeness->correlation : 1;
        };
        const std::vector<Tried> all =
            tried_readings(truth_, test_, valid_, std::span(kReadings).first(turned_in_whole ? 4 : 1));
        const Tried& given = all.front();
        if (!given.likeness) return given;
        std::size_t best = 0;
        for (std::size_t r = 1; r < all.size(); ++r) {
            if (share(all[r]) < share(all[best]) && share(all[r]) <= kTurnedGain * share(given)) best = r;
        }
        if (best > 0) {
            const Turn& turn = kTurns[best - 1];
            say("the picture seems to be {} (correlation {:.2f}, as given {:.2f}): change {}", turn.meaning,
                all[best].likeness->correlation, given.likeness->correlation, turn.options);
        }
        return all[best];
    }

    /// Tries whether the file's numbers follow the truth better with the curve of sRGB removed, or applied.
    void add_coding(const Reading& reading) {
        const bool decoded = reading_.srgb_floats || (test_.integers && reading_.coding == Coding::srgb);
        Reading readings[] = {reading, reading, reading};
        readings[1].curve = put_srgb_on;
        readings[2].curve = take_srgb_off;
        const std::vector<Tried> all = tried_readings(truth_, test_, valid_, readings);
        const Tried &given = all[0], &brighter = all[1], &darker = all[2];
        const auto better = [&](const Tried& other) {
            return given.likeness && other.likeness && other.likeness->rmse < given.likeness->rmse &&
                   other.likeness->unexplained() < kCodedGain * given.likeness->unexplained();
        };
        if (better(darker)) {
            say("the picture seems to be sRGB-coded{} (correlation {:.3f} with the curve taken off, as read "
                "{:.3f}): try {}",
                decoded ? " twice" : "", darker.likeness->correlation, given.likeness->correlation,
                test_.integers ? "--srgb" : "--srgb-floats");
        } else if (better(brighter)) {
            say("the picture seems to be linear already, and to have had the curve of sRGB taken off "
                "(correlation {:.3f} with the curve put back, as read {:.3f}): {}",
                brighter.likeness->correlation, given.likeness->correlation,
                !decoded         ? "export it without"
                : test_.integers ? "try --linear"
                                 : "leave out --srgb-floats");
        }
    }

    const VisibilityFile& truth_;
    const VisibilityFile& test_;
    const Mask& valid_;
    const VisibilityReading& reading_;
};

}  // namespace

std::vector<std::string> picture_doubts(const VisibilityFile& truth, const VisibilityFile& test,
                                        const Mask& valid, const VisibilityReading& reading,
                                        bool turned_in_whole) {
    Doubts doubts(truth, test, valid, reading);
    doubts.add_range(truth.visibility, "the truth");
    doubts.add_range(test.visibility, "the test");
    doubts.add_readings(turned_in_whole);
    return std::move(doubts.said);
}

}  // namespace aoscore
