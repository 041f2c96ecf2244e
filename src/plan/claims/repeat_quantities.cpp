#include "plan/claims/repeat_quantities.h"

#include "metrics/analysis/repeats.h"
#include "plan/claims/block_draws.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace aoscore::repeat_quantities {
namespace {

using Blocks = std::vector<double>;

constexpr const char *kBentNormal = "bent_normal", *kConeAngle = "cone_angle";

Measured noise_of(const std::optional<Repeats>& repeats, Blocks Repeats::*variance, double strength,
                  std::uint64_t seed) {
    if (!repeats) return {};
    return over_blocks(
        {&((*repeats).*variance), &repeats->counts},
        [strength](const auto& s) { return strength * std::sqrt(s[0] / s[1]); }, seed);
}

Measured root_mean(const CellRecord& cell, std::optional<Convergence> Repeats::*which,
                   Blocks Convergence::*squares, std::uint64_t seed) {
    if (!cell.repeats || !((*cell.repeats).*which)) return {};
    const Convergence& sums = *((*cell.repeats).*which);
    return over_blocks(
        {&(sums.*squares), &sums.counts}, [](const auto& s) { return std::sqrt(s[0] / s[1]); }, seed);
}

const FoundOcclusion* found_in(const CellRecord& cell, std::optional<FoundOcclusion> Repeats::*which) {
    if (!cell.repeats || !((*cell.repeats).*which)) return nullptr;
    return &*((*cell.repeats).*which);
}

Measured part(const FoundOcclusion* found, Blocks FoundOcclusion::*some, Blocks FoundOcclusion::*all,
              std::uint64_t seed) {
    if (found == nullptr) return {};
    return over_blocks(
        {&(found->*some), &(found->*all)}, [](const auto& s) { return s[0] / s[1]; }, seed);
}

/// The standard deviation over pixels of the part that is found, over its mean.
Measured unevenness(const FoundOcclusion* found, std::uint64_t seed) {
    if (found == nullptr) return {};
    return over_blocks(
        {&found->parts, &found->squared_parts, &found->pixels},
        [](const auto& s) {
            const double mean = s[0] / s[2];
            return std::sqrt(std::max(s[1] / s[2] - mean * mean, 0.0)) / mean;
        },
        seed);
}

Measured angle(const CellRecord& cell, std::map<std::string, AngleBlocks> Repeats::*where, const char* signal,
               Blocks AngleBlocks::*sums, std::uint64_t seed) {
    if (!cell.repeats) return {};
    const auto& angles = (*cell.repeats).*where;
    const auto found = angles.find(signal);
    if (found == angles.end()) return {};
    return over_blocks(
        {&(found->second.*sums), &found->second.counts}, [](const auto& s) { return s[0] / s[1]; }, seed);
}

}  // namespace

Measured repeats_noise(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return noise_of(cell.repeats, &Repeats::variance, 1, seed);
}

Measured repeats_raw_noise(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return noise_of(cell.repeats, &Repeats::raw_variance, 1, seed);
}

Measured repeats_fitted_noise(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    const FoundOcclusion* found = found_in(cell, &Repeats::of_truth);
    if (found == nullptr) return {};
    return noise_of(cell.repeats, &Repeats::variance, found->strength, seed);
}

Measured unconverged(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return root_mean(cell, &Repeats::from_converged, &Convergence::squares, seed);
}

Measured raw_unconverged(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return root_mean(cell, &Repeats::raw_from_converged, &Convergence::squares, seed);
}

Measured raw_unconverged_bands(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return root_mean(cell, &Repeats::raw_from_converged, &Convergence::bands, seed);
}

Measured found_of_truth(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_truth), &FoundOcclusion::found_fitted, &FoundOcclusion::hidden,
                seed);
}

Measured found_of_grazing(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_grazing), &FoundOcclusion::found_fitted, &FoundOcclusion::hidden,
                seed);
}

Measured unevenness_of_truth(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return unevenness(found_in(cell, &Repeats::of_truth), seed);
}

Measured unevenness_of_grazing(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return unevenness(found_in(cell, &Repeats::of_grazing), seed);
}

Measured found_of_layers(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_layers), &FoundOcclusion::found, &FoundOcclusion::hidden, seed);
}

Measured found_fitted_of_layers(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_layers), &FoundOcclusion::found_fitted, &FoundOcclusion::hidden,
                seed);
}

Measured kept_of_layers(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_layers), &FoundOcclusion::kept, &FoundOcclusion::visible, seed);
}

Measured finders_of_layers(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return part(found_in(cell, &Repeats::of_layers), &FoundOcclusion::finders, &FoundOcclusion::pixels, seed);
}

Measured hidden_bent_angle(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return angle(cell, &Repeats::hidden_angles, kBentNormal, &AngleBlocks::absolute_sums, seed);
}

Measured other_bent_angle(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return angle(cell, &Repeats::other_angles, kBentNormal, &AngleBlocks::absolute_sums, seed);
}

Measured hidden_cone_error(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return angle(cell, &Repeats::hidden_angles, kConeAngle, &AngleBlocks::absolute_sums, seed);
}

Measured hidden_cone_bias(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return angle(cell, &Repeats::hidden_angles, kConeAngle, &AngleBlocks::signed_sums, seed);
}

Measured other_cone_error(const CellRecord& cell, const ViewRecord&, std::uint64_t seed) {
    return angle(cell, &Repeats::other_angles, kConeAngle, &AngleBlocks::absolute_sums, seed);
}

}  // namespace aoscore::repeat_quantities
