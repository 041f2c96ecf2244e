#include "screen/method/depth_layers.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace aoscore {
namespace {

/// The members with their accepted values; a missing member has its default.
const std::vector<Parameter>& members() {
    static const std::vector<Parameter> all = [] {
        std::vector<Parameter> made(6);
        made[0] = {"samples", Parameter::Type::integer, 1, 1, DepthLayers::kMost, {}, "", ""};
        made[1] = {"alpha", Parameter::Type::real, 0.2, 0, 1, {}, "", ""};
        made[2] = {"sampling", Parameter::Type::choice,   "stratified", 0,
                   0,          ids_of(depth_samplings()), "",           ""};
        made[3] = {"per_sample", Parameter::Type::boolean, true, 0, 0, {}, "", ""};
        made[4] = {"seed", Parameter::Type::integer, 0, 0, std::numeric_limits<int>::max(), {}, "", ""};
        made[5] = {"least_gap", Parameter::Type::real, 0.0, 0, 1e7, {}, "m", ""};
        return made;
    }();
    return all;
}

/// Whether the member accepts every value of the parameter.
bool fits(const Parameter& parameter, const Parameter& member) {
    const bool within = parameter.lowest >= member.lowest && parameter.highest <= member.highest;
    const bool known = std::ranges::all_of(parameter.choices, [&](const std::string& choice) {
        return std::ranges::find(member.choices, choice) != member.choices.end();
    });
    return parameter.type == member.type && within && known;
}

bool is_reference(const ParameterValue& value) {
    return value.is_word() && value.word().starts_with('@');
}

void check_member(const Parameter& member, const ParameterValue& value, const MethodDescriptor& method,
                  const std::string& where) {
    const std::string valid = fmt::format("{}; or @ and a parameter that takes nothing else", member.valid());
    if (!is_reference(value)) {
        if (!member.accepts(value)) throw file_error(fmt::format("is {}", value.quoted()), where, valid);
        return;
    }
    const Parameter* parameter = method.find_parameter(value.word().substr(1));
    if (parameter == nullptr || !fits(*parameter, member))
        throw file_error(fmt::format("is {}", value.quoted()), where, valid);
}

}  // namespace

const std::vector<DepthSampling>& depth_samplings() {
    static const std::vector<DepthSampling> table = {
        {"stratified", "SAMPLING_STRATIFIED",
         "a surface takes alpha S samples, rounded up or down at random, in any of their combinations"},
        {"simple_hash", "SAMPLING_SIMPLE_HASH", "a coin for each sample, from pixel, triangle and sample"},
        {"hash_4d", "SAMPLING_HASH_4D", "the same, hashed one after the other, four samples at a time"},
        {"isotropic", "SAMPLING_ISOTROPIC", "a coin for each sample, from a place in the scene"},
        {"anisotropic", "SAMPLING_ANISOTROPIC", "the same, with a scale of its own along each axis"},
        {"peeled", "SAMPLING_PEELED", "no coins: the layers from front to back"},
    };
    return table;
}

DepthLayersDescriptor parse_depth_layers(const MethodDescriptor& method, StrictObject object) {
    DepthLayersDescriptor descriptor;
    for (const Parameter& member : members()) {
        const std::string where = object.where(member.id);
        const ParameterValue value =
            object.has(member.id) ? parameter_value(object.raw(member.id), where) : member.default_value;
        check_member(member, value, method, where);
        descriptor.members[member.id] = value;
    }
    object.finish();
    return descriptor;
}

bool names_parameter(const DepthLayersDescriptor& descriptor, std::string_view parameter) {
    const ParameterValue reference(fmt::format("@{}", parameter));
    return std::ranges::any_of(descriptor.members,
                               [&](const auto& member) { return member.second == reference; });
}

DepthLayers asked_depth_layers(const DepthLayersDescriptor& descriptor, const ParameterValues& parameters,
                               std::uint64_t run_seed) {
    const auto value = [&](const char* member) {
        const ParameterValue& given = descriptor.members.at(member);
        return is_reference(given) ? parameters.at(given.word().substr(1)) : given;
    };
    DepthLayers layers;
    layers.samples = static_cast<int>(value("samples").number());
    layers.alpha = value("alpha").number();
    layers.sampling = value("sampling").word();
    layers.per_sample = value("per_sample").boolean();
    const auto own_seed = static_cast<std::uint32_t>(value("seed").number());
    layers.seed = own_seed == 0 ? static_cast<std::uint32_t>(run_seed) : own_seed;
    layers.least_gap_m = value("least_gap").number();
    return layers;
}

namespace {

std::optional<ParameterValues> parameters_for(const DepthLayersDescriptor& descriptor,
                                              const ParameterValues& members_wanted) {
    ParameterValues changes;
    for (const auto& [member, value] : members_wanted) {
        const ParameterValue& given = descriptor.members.at(member);
        if (!is_reference(given) && given != value) return std::nullopt;
        if (is_reference(given)) changes[given.word().substr(1)] = value;
    }
    return changes;
}

}  // namespace

std::optional<ParameterValues> first_layer_alone(const DepthLayersDescriptor& descriptor) {
    return parameters_for(descriptor, {{"samples", 1}, {"alpha", 1.0}, {"sampling", "stratified"}});
}

std::optional<ParameterValues> all_layers(const DepthLayersDescriptor& descriptor) {
    return parameters_for(descriptor, {{"samples", DepthLayers::kMost}, {"sampling", "peeled"}});
}

}  // namespace aoscore
