#include "screen/method/depth_layers.h"

#include "core/error.h"
#include "core/known_names.h"
#include "screen/method/input_members.h"

#include <fmt/format.h>

#include <limits>

namespace aoscore {
namespace {

constexpr std::string_view kStaticAndDynamic = "static_and_dynamic";

}  // namespace

const std::vector<DepthSampling>& depth_samplings() {
    static const std::vector<DepthSampling> table = {
        {"stratified", "SAMPLING_STRATIFIED",
         "a surface takes alpha S samples, rounded up or down at random, in any of their combinations", true,
         true},
        {"simple_hash", "SAMPLING_SIMPLE_HASH", "a coin for each sample, from pixel, triangle and sample",
         true, true},
        {"hash_4d", "SAMPLING_HASH_4D", "the same, hashed one after the other, four samples at a time", true,
         true},
        {"isotropic", "SAMPLING_ISOTROPIC", "a coin for each sample, from a place in the scene", true},
        {"anisotropic", "SAMPLING_ANISOTROPIC", "the same, with a scale of its own along each axis", true},
        {"peeled", "SAMPLING_PEELED", "no coins: the layers from front to back", false, true},
        {"rays", "",
         "of a ray through the pixel: the first surface, and of those behind it any, with one probability"},
        {kStaticAndDynamic, "SAMPLING_STATIC_AND_DYNAMIC",
         "no coins: two samples, the nearest of what stands still and the nearest of what moves"},
    };
    return table;
}

bool is_rasterised(std::string_view sampling) {
    return !row_of(depth_samplings(), sampling, "no sampling of depth layers").macro.empty();
}

int stored_depths(int samples) {
    constexpr int kInTexel = 4;
    return samples <= 2 ? samples : (samples + kInTexel - 1) / kInTexel * kInTexel;
}

const std::vector<Parameter>& depth_layers_members() {
    static const std::vector<Parameter> all = [] {
        std::vector<Parameter> made(8);
        made[0] = {"samples", Parameter::Type::integer, 1, 1, DepthLayers::kMost, {}, "", ""};
        made[1] = {"alpha", Parameter::Type::real, 0.2, 0, 1, {}, "", ""};
        made[2] = {"sampling", Parameter::Type::choice,   "stratified", 0,
                   0,          ids_of(depth_samplings()), "",           ""};
        made[3] = {"per_sample", Parameter::Type::boolean, true, 0, 0, {}, "", ""};
        made[4] = {"seed", Parameter::Type::integer, 0, 0, std::numeric_limits<int>::max(), {}, "", ""};
        made[5] = {"least_gap", Parameter::Type::real, 0.0, 0, 1e7, {}, "m", ""};
        made[6] = {"reach", Parameter::Type::real, 0.0, 0, 1e7, {}, "m", ""};
        made[7] = {"facing", Parameter::Type::boolean, false, 0, 0, {}, "", ""};
        return made;
    }();
    return all;
}

DepthLayers asked_depth_layers(const InputMembers& input, const ParameterValues& parameters,
                               std::uint64_t run_seed) {
    const auto value = [&](const char* member) { return member_value(input, parameters, member); };
    DepthLayers layers;
    layers.samples = static_cast<int>(value("samples").number());
    layers.alpha = value("alpha").number();
    layers.sampling = value("sampling").word();
    layers.per_sample = value("per_sample").boolean();
    const auto own_seed = static_cast<std::uint32_t>(value("seed").number());
    layers.seed = own_seed == 0 ? static_cast<std::uint32_t>(run_seed) : own_seed;
    layers.least_gap_m = value("least_gap").number();
    layers.reach_m = value("reach").number();
    layers.facing = value("facing").boolean();
    if (layers.facing && layers.sampling != "peeled") {
        throw usage_error("front and back faces are told apart in peeled layers alone", "depth layers",
                          "sampling peeled");
    }
    if (layers.sampling == kStaticAndDynamic && layers.samples != 2) {
        throw usage_error(fmt::format("what stands still and what moves are 2 layers, not {}", layers.samples),
                          "depth layers", "2 samples");
    }
    return layers;
}

namespace {

std::optional<ParameterValues> with_layers(const MethodDescriptor& method, const ParameterValues& wanted) {
    if (!method.depth_layers) return std::nullopt;
    std::optional<ParameterValues> changes = parameters_for(*method.depth_layers, wanted);
    if (!changes || !method.side_layers) return changes;
    const std::optional<ParameterValues> alone = parameters_for(*method.side_layers, {{"cameras", 0}});
    if (!alone) return std::nullopt;
    changes->insert(alone->begin(), alone->end());
    return changes;
}

}  // namespace

bool reads_ray_layers(const MethodDescriptor& method, const ParameterValues& parameters) {
    const auto by_rays = [&](const std::optional<InputMembers>& input) {
        return input && !is_rasterised(member_value(*input, parameters, "sampling").word());
    };
    return by_rays(method.depth_layers) || by_rays(method.side_layers);
}

std::optional<ParameterValues> first_layer_alone(const MethodDescriptor& method) {
    return with_layers(method,
                       {{"samples", 1}, {"alpha", 1.0}, {"sampling", "stratified"}, {"facing", false}});
}

std::optional<ParameterValues> all_layers(const MethodDescriptor& method) {
    return with_layers(method, {{"samples", DepthLayers::kMost}, {"sampling", "peeled"}});
}

}  // namespace aoscore
