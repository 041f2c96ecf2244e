#include "compare/picture_doubts.h"

#include "core/threads.h"
#include "image/image_frame.h"
#include "metrics/analysis/likeness.h"
#include "metrics/measures/srgb_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
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

/// A way to read the test that may be the right one.
struct Variant {
    ImageF test;
    Mask valid;
    std::optional<Likeness> likeness;
};

class Doubts {
  public:
    Doubts(const VisibilityFile& truth, const VisibilityFile& test, const Mask& valid,
           const VisibilityReading& reading)
        : truth_(truth), test_(test), valid_(valid), reading_(reading) {}

    void add_range(const ImageF& image, const char* name) {
        std::size_t below = 0, above = 0, count = 0;
        float least = 0, most = 1;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const float value = image.pixels[i];
            if (valid_.pixels[i] == 0 || !std::isfinite(value)) continue;
            ++count;
            below += value < -kBeyondNoise ? 1 : 0;
            above += value > 1 + kBeyondNoise ? 1 : 0;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        if (below + above == 0) return;
        say("{}: of {} pixels {} are below 0 and {} above 1 (from {:.4g} to {:.4g}), which no visibility is",
            name, count, below, above, least, most);
    }

    void add_readings(bool turned_in_whole) {
        const Variant given = variant(test_.visibility, valid_);
        if (!given.likeness) return;
        const Variant best = turned_in_whole ? best_orientation(given) : given;
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
            const bool holds_occlusion = reading_.invert != inverted;
            add_coding(inverted ? variant(inverted_of(best.test), best.valid) : best, holds_occlusion);
        }
    }

    std::vector<std::string> said;

  private:
    template <class... Parts>
    void say(fmt::format_string<Parts...> text, Parts&&... parts) {
        said.push_back(fmt::format(text, std::forward<Parts>(parts)...));
    }

    Variant variant(ImageF test, Mask valid) const {
        Variant result{std::move(test), std::move(valid), {}};
        result.likeness = likeness({truth_.visibility, result.test, result.valid});
        return result;
    }

    /// Applies `change` to the picture's values, clamped to [0,1], row by row; NaN stays.
    static ImageF changed(ImageF image, const std::function<void(std::span<double>)>& change) {
        const auto width = static_cast<std::size_t>(image.width);
        parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t y) {
            const std::span<float> row(&image.at(0, static_cast<int>(y)), width);
            std::vector<double> values(row.begin(), row.end());
            for (double& value : values) value = std::clamp(value, 0.0, 1.0);
            change(values);
            for (std::size_t x = 0; x < width; ++x) {
                if (!std::isnan(row[x])) row[x] = static_cast<float>(values[x]);
            }
        });
        return image;
    }
    static void invert(std::span<double> values) {
        for (double& value : values) value = 1 - value;
    }
    static ImageF inverted_of(ImageF image) { return changed(std::move(image), invert); }

    Variant best_orientation(const Variant& given) {
        struct Turn {
            Orientation orientation;
            const char* meaning;
            const char* options;
        };
        const auto share = [](const Variant& v) {
            return v.likeness ? 1 - v.likeness->correlation * v.likeness->correlation : 1;
        };
        Variant best = given;
        const Turn* found = nullptr;
        static constexpr Turn kTurns[] = {
            {{false, false, true}, "upside down", "--flip"},
            {{false, true, false}, "mirrored", "--mirror"},
            {{false, true, true}, "upside down and mirrored", "--flip and --mirror"}};
        for (const Turn& turn : kTurns) {
            Mask valid = shown(test_.mask, turn.orientation);
            for (std::size_t i = 0; i < valid.size(); ++i) valid.pixels[i] &= truth_.mask.pixels[i];
            Variant other = variant(shown(test_.visibility, turn.orientation), std::move(valid));
            if (share(other) >= share(best) || share(other) > kTurnedGain * share(given)) continue;
            best = std::move(other);
            found = &turn;
        }
        if (found != nullptr) {
            say("the picture seems to be {} (correlation {:.2f}, as given {:.2f}): change {}", found->meaning,
                best.likeness->correlation, given.likeness->correlation, found->options);
        }
        return best;
    }

    /// Tries whether the file's numbers follow the truth better with the curve of sRGB removed, or applied.
    void add_coding(const Variant& given, bool holds_occlusion) {
        const bool decoded = reading_.srgb_floats || (test_.integers && reading_.coding == Coding::srgb);
        const auto with = [&](void (*curve)(std::span<double>)) {
            const auto change = [&](std::span<double> values) {
                if (holds_occlusion) invert(values);
                curve(values);
                if (holds_occlusion) invert(values);
            };
            return variant(changed(given.test, change), given.valid);
        };
        const auto better = [&](const Variant& other) {
            return other.likeness && other.likeness->rmse < given.likeness->rmse &&
                   other.likeness->unexplained() < kCodedGain * given.likeness->unexplained();
        };
        const Variant brighter = with(put_srgb_on), darker = with(take_srgb_off);
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
