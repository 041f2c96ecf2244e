#include "screen/method/method_data.h"

#include "core/folders.h"
#include "screen/gbuffer/derived_inputs.h"
#include "screen/method/depth_layers.h"
#include "screen/method/kernel.h"
#include "screen/passes/pass_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

// The shortest number that reads back as this float, with a third of the digits of its double.
double short_number(float value) {
    return std::stod(fmt::format("{}", value));
}

const char* type_name(Parameter::Type type) {
    switch (type) {
        case Parameter::Type::integer:
            return "integer";
        case Parameter::Type::real:
            return "real";
        case Parameter::Type::boolean:
            return "boolean";
        case Parameter::Type::choice:
            return "choice";
    }
    return "";
}

json parameter_data(const Parameter& p) {
    json data = {{"id", p.id},     {"type", type_name(p.type)},      {"default", p.default_value},
                 {"unit", p.unit}, {"length_power", p.length_power}, {"meaning", p.meaning}};
    if (p.type == Parameter::Type::integer || p.type == Parameter::Type::real) {
        data["low"] = p.lowest;
        data["high"] = p.highest;
    }
    if (p.type == Parameter::Type::choice) data["choices"] = p.choices;
    return data;
}

int largest_size(const Kernel& kernel, const MethodDescriptor& method) {
    if (!kernel.size.starts_with('@')) return std::stoi(kernel.size);
    return static_cast<int>(method.find_parameter(kernel.size.substr(1))->highest);
}

/// Every way of choosing the parameters that members of the kernel name.
std::vector<ParameterValues> settings_of(const Kernel& kernel, const MethodDescriptor& method) {
    std::vector<ParameterValues> settings(1);
    for (const std::string& member : {kernel.directions, kernel.radii, kernel.sequence}) {
        if (!member.starts_with('@') || settings.front().contains(member.substr(1))) continue;
        std::vector<ParameterValues> longer;
        for (const ParameterValues& setting : settings) {
            for (const std::string& choice : method.find_parameter(member.substr(1))->choices) {
                longer.push_back(setting);
                longer.back()[member.substr(1)] = choice;
            }
        }
        settings = std::move(longer);
    }
    return settings;
}

json kernel_data(const Kernel& kernel, const MethodDescriptor& method, std::uint64_t seed) {
    const int largest = largest_size(kernel, method);
    json data = {{"id", kernel.id},
                 {"size", kernel.size},
                 {"scale", kernel.scale},
                 {"largest", largest},
                 {"tables", json::array()}};
    for (const ParameterValues& setting : settings_of(kernel, method)) {
        Kernel full = kernel;
        full.size = std::to_string(largest);
        full.scale = "none";
        for (std::string* member : {&full.directions, &full.radii, &full.sequence}) {
            if (member->starts_with('@')) *member = setting.at(member->substr(1)).word();
        }
        json points = json::array();
        for (const glm::vec3& p : generate_kernel(full, seed)) {
            for (const float component : {p.x, p.y, p.z}) points.push_back(short_number(component));
        }
        data["tables"].push_back({{"when", setting}, {"points", std::move(points)}});
    }
    return data;
}

void add_passes(json& data, const MethodDescriptor& method) {
    PassBuild build;
    build.method = &method;
    build.uniform_form = true;
    std::vector<std::string> files;
    data["passes"] = json::array();
    data["sources"] = json::array();
    for (const Pass& pass : method.passes) {
        auto file = std::find(files.begin(), files.end(), pass.fragment);
        if (file == files.end()) {
            data["sources"].push_back(pass_source_without_macros(build, pass).text());
            file = files.insert(files.end(), pass.fragment);
        }
        data["passes"].push_back(
            {{"inputs", pass.inputs}, {"scale", pass.scale}, {"source", file - files.begin()}});
    }
}

std::string gbuffer_shader(const std::string& name) {
    ShaderSource source;
    const auto folder = data_dir() / "shaders" / "gbuffer";
    source.add_file(folder / name, folder);
    return source.text();
}

}  // namespace

json method_data(const MethodDescriptor& method, std::uint64_t seed) {
    json data = {{"id", method.id},
                 {"label", method.shown_label()},
                 {"summary", method.summary},
                 {"parameters", json::array()},
                 {"presets", json::object()},
                 {"preset_filters", json::object()},
                 {"absolute_presets", method.absolute_presets}};
    for (const Parameter& p : method.parameters) {
        if (p.signal.empty()) data["parameters"].push_back(parameter_data(p));
    }
    for (const auto& [preset, unused] : method.presets)
        data["presets"][preset] = visibility_values(method, method.values(preset));
    for (const auto& [preset, own] : method.preset_filters)
        data["preset_filters"][preset] = {{"filter", own.filter}, {"preset", own.preset}};
    const auto processed = std::find_if(method.passes.begin(), method.passes.end(),
                                        [](const Pass& p) { return !p.processor.empty(); });
    if (processed != method.passes.end()) {
        data["processor"] = processed->processor;
        return data;
    }
    add_passes(data, method);
    data["kernels"] = json::array();
    for (const Kernel& kernel : method.kernels) data["kernels"].push_back(kernel_data(kernel, method, seed));
    data["depth_mips"] = {{"filter", method.depth_mips.filter},
                          {"radius", method.depth_mips.radius_parameter}};
    if (method.depth_layers) data["depth_layers"] = method.depth_layers->members;
    if (method.side_layers) data["side_layers"] = method.side_layers->members;
    return data;
}

json contract_data(std::uint64_t seed) {
    json noise = json::array();
    for (const glm::vec4& texel : generate_noise_4x4(seed).pixels) {
        for (const float number : {texel.x, texel.y, texel.z, texel.w}) noise.push_back(short_number(number));
    }
    json derived = json::object();
    for (const char* file :
         {"depth_mip.frag", "gathered_layers.frag", "normal_from_depth.frag", "upsample.frag"})
        derived[file] = gbuffer_shader(file);
    json samplings = json::object();
    for (const DepthSampling& sampling : depth_samplings()) {
        if (sampling.of_kept_surfaces) samplings[std::string(sampling.id)] = sampling.macro;
    }
    return {{"screen_vertex", gbuffer_shader("screen.vert")},
            {"derived", std::move(derived)},
            {"noise_4x4", std::move(noise)},
            {"macros", pass_macros({})},
            {"layer_samplings", std::move(samplings)},
            {"depth_mip_levels", DerivedInputs::kMipLevels},
            {"seed", static_cast<std::uint32_t>(seed)}};
}

}  // namespace aoscore
