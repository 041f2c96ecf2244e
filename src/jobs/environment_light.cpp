#include "jobs/environment_light.h"

#include "core/error.h"
#include "core/threads.h"
#include "jobs/truth_signals.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/intervals/bootstrap.h"
#include "results/record_json.h"
#include "results/results_members.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// What the store keeps of a cell's light.
struct StoredErrors {
    LightErrors errors;
};

template <class Visit, RecordOf<StoredErrors> Record>
void visit_members(Visit& visit, Record& stored) {
    visit("errors", stored.errors);
}

constexpr const char *kBentNormal = "bent_normal", *kConeAngle = "cone_angle";

/// Sums over blocks of the picture of one mode's errors. Squared ones are products of the errors against both
/// halves of the truth: its noise is not in them, since neither half knows of the other.
struct ModeSums {
    std::vector<double> products, errors, truths, counts;
    explicit ModeSums(std::size_t blocks)
        : products(blocks, 0), errors(blocks, 0), truths(blocks, 0), counts(blocks, 0) {}
};

ModeSums sums_of(const Image<glm::vec3>& lit, const Irradiance& truth, const Mask& valid) {
    const BlockGrid grid(valid.width, valid.height);
    ModeSums sums(grid.size());
    for (int y = 0; y < valid.height; ++y) {
        const std::size_t row = valid.index(0, y);
        grid.for_each_piece(y, 0, valid.width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) {
                const std::size_t i = row + static_cast<std::size_t>(x);
                if (valid.pixels[i] == 0) continue;
                const double value = luminance(glm::dvec3(lit.pixels[i]));
                const double first = luminance(glm::dvec3(truth.halves[0].pixels[i]));
                const double second = luminance(glm::dvec3(truth.halves[1].pixels[i]));
                sums.products[block] += (value - first) * (value - second);
                sums.errors[block] += value - (first + second) / 2;
                sums.truths[block] += (first + second) / 2;
                sums.counts[block] += 1;
            }
        });
    }
    return sums;
}

/// The measures of one mode over blocks.
struct ModeErrors {
    double rmse = 0, relative_rmse = 0, bias = 0;
};

/// `counted` says how often each block counts.
ModeErrors errors_of(const ModeSums& sums, const std::vector<double>& counted) {
    double product = 0, error = 0, truth = 0, count = 0;
    for (std::size_t b = 0; b < counted.size(); ++b) {
        product += counted[b] * sums.products[b];
        error += counted[b] * sums.errors[b];
        truth += counted[b] * sums.truths[b];
        count += counted[b] * sums.counts[b];
    }
    const double rmse = std::sqrt(std::max(product / count, 0.0));
    return {rmse, rmse / (truth / count), error / truth};
}

/// A mode's measures, and their values over resampled pictures.
struct MeasuredMode {
    const LightMode& mode;
    ModeSums sums;
    ModeErrors errors;
    std::vector<double> rmse, relative_rmse, bias;
};

void resample(std::vector<MeasuredMode>& modes, std::uint64_t seed) {
    constexpr int kResamples = 2000;
    const std::size_t blocks = modes.front().sums.counts.size();
    std::mt19937_64 random(seed);
    for (int i = 0; i < kResamples; ++i) {
        std::vector<double> counted(blocks, 0);
        for (std::size_t k = 0; k < blocks; ++k) counted[random() % blocks] += 1;
        for (MeasuredMode& mode : modes) {
            const ModeErrors drawn = errors_of(mode.sums, counted);
            mode.rmse.push_back(drawn.rmse);
            mode.relative_rmse.push_back(drawn.relative_rmse);
            mode.bias.push_back(drawn.bias);
        }
    }
}

const SignalImage& signal_of(const MethodOutput& image, const char* id) {
    const auto found = image.signals.find(id);
    if (found == image.signals.end()) throw internal_error("light needs the signal", id);
    return found->second;
}

glm::dvec3 vector_at(const SignalImage& planes, std::size_t i) {
    return {double{planes[0].pixels[i]}, double{planes[1].pixels[i]}, double{planes[2].pixels[i]}};
}

}  // namespace

bool applies(const LightMode& mode, const MethodOutput& image) {
    return (!mode.bent || image.signals.contains(kBentNormal)) &&
           (!mode.cone || image.signals.contains(kConeAngle));
}

Image<glm::vec3> lit_image(const LightMode& mode, const EnvironmentLight& light, const MethodOutput& image,
                           const Mask& valid) {
    const SignalImage* bent = mode.bent ? &signal_of(image, kBentNormal) : nullptr;
    const SignalImage* cone = mode.cone ? &signal_of(image, kConeAngle) : nullptr;
    const glm::dmat3 world_from_view(light.frame.world_from_view());
    const auto lit_pixel = [&](std::size_t i) {
        glm::dvec3 axis(light.normals.pixels[i]);
        if (bent != nullptr) {
            const glm::dvec3 open = vector_at(*bent, i);
            const double length = glm::length(open);
            if (length > 0) axis = open / length;
        }
        const double half_angle = cone != nullptr ? double{(*cone)[0].pixels[i]} : std::numbers::pi / 2;
        const double sine = std::sin(half_angle);
        const double open_part = mode.alone ? sine * sine : double{image.visibility.pixels[i]};
        return glm::vec3(open_part * light.cones.mean_radiance(world_from_view * axis, half_angle));
    };
    Image<glm::vec3> lit(valid.width, valid.height, glm::vec3(0));
    const auto width = static_cast<std::size_t>(valid.width);
    parallel_for(static_cast<std::size_t>(valid.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            if (valid.pixels[i] != 0) lit.pixels[i] = lit_pixel(i);
        }
    });
    return lit;
}

LightErrors light_errors(const EnvironmentLight& light, const MethodOutput& image, const Irradiance& truth,
                         const Mask& valid, std::uint64_t seed) {
    std::vector<MeasuredMode> modes;
    for (const LightMode& mode : light_modes()) {
        if (!applies(mode, image)) continue;
        ModeSums sums = sums_of(lit_image(mode, light, image, valid), truth, valid);
        const ModeErrors errors = errors_of(sums, std::vector<double>(sums.counts.size(), 1));
        if (!std::isfinite(errors.relative_rmse)) return {};  // nothing is valid, or nothing is lit
        modes.push_back({mode, std::move(sums), errors, {}, {}, {}});
    }
    resample(modes, seed);
    LightErrors measures;
    for (std::size_t m = 0; m < modes.size(); ++m) {
        const auto& [mode, sums, errors, rmse, relative_rmse, bias] = modes[m];
        measures[mode.error()] = {errors.rmse, confidence_interval(rmse)};
        measures[mode.relative_error()] = {errors.relative_rmse, confidence_interval(relative_rmse)};
        measures[mode.bias()] = {errors.bias, confidence_interval(bias)};
        if (m == 0) continue;
        measures[mode.gain()] = {modes[m - 1].errors.rmse - errors.rmse,
                                 confidence_interval(modes[m - 1].rmse, rmse)};
    }
    return measures;
}

LightRecord light_record(const EnvironmentLight& light, const Environment& environment, const Truth& truth,
                         const Irradiance& irradiance, const Mask& valid, std::uint64_t seed) {
    MethodOutput of_truth;
    of_truth.visibility = truth.visibility[0];
    for (const std::string& id : held_signals(truth)) of_truth.signals[id] = truth_signal(truth, id).image;
    return {.environment = environment.id(),
            .file = {},
            .mean = mean_luminance(irradiance, valid),
            .standard_error = standard_error(irradiance, valid),
            .samples = irradiance.samples,
            .of_truth = light_errors(light, of_truth, irradiance, valid, seed)};
}

nlohmann::json to_json(const LightRecord& record) {
    return record_json::checked_json(record, "light of the view");
}

LightRecord light_record_from_json(const nlohmann::json& json, const std::string& where) {
    return record_json::record_from_json<LightRecord>(json, where);
}

nlohmann::json to_json(const LightErrors& errors) {
    return record_json::checked_json(StoredErrors{errors}, "light");
}

LightErrors light_errors_from_json(const nlohmann::json& json, const std::string& where) {
    return record_json::record_from_json<StoredErrors>(json, where).errors;
}

}  // namespace aoscore
