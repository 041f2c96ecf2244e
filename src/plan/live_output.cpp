#include "plan/live_output.h"

#include "core/error.h"
#include "core/files.h"
#include "core/json_text.h"
#include "results/live_file.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/method/method_data.h"

namespace aoscore {
namespace {

using nlohmann::json;

/// The lengths of one method or filter, by preset.
json lengths_of(const MethodDescriptor& descriptor, std::optional<double> drawn_for_m) {
    json lengths = json::object();
    for (const auto& [preset, unused] : descriptor.presets) {
        try {
            const ParameterValues values = drawn_values(descriptor, preset, {}, drawn_for_m);
            for (const Parameter& p : descriptor.parameters) {
                if (p.length_power != 0) lengths[preset][p.id] = values.at(p.id);
            }
        } catch (const Error&) {
            // This preset was not measured, and its ranges end before this radius, as the sliders do.
        }
    }
    return lengths;
}

json lengths_of(const std::vector<MethodDescriptor>& all, std::optional<double> drawn_for_m) {
    json lengths = json::object();
    for (const MethodDescriptor& one : all) {
        json of_one = lengths_of(one, drawn_for_m);
        if (!of_one.empty()) lengths[one.id] = std::move(of_one);
    }
    return lengths;
}

json view_data(const LiveView& live, const Registry& registry) {
    const ViewUniforms view(live.frame);
    return {{"own_parameters", !live.drawn_for_m},
            {"method_lengths", lengths_of(registry.methods, live.drawn_for_m)},
            {"filter_lengths", lengths_of(registry.filters, live.drawn_for_m)},
            {"width", view.width},
            {"height", view.height},
            {"near_m", view.near},
            {"far_m", view.far},
            {"pixel_size", {view.pixel_size.x, view.pixel_size.y}},
            {"orthographic", view.orthographic},
            {"surfaces", live.keeps_surfaces}};
}

json descriptors(const std::vector<MethodDescriptor>& all, std::uint64_t seed) {
    json list = json::array();
    for (const MethodDescriptor& one : all) list.push_back(method_data(one, seed));
    return list;
}

}  // namespace

std::set<std::string> gbuffer_inputs_of(const Registry& registry) {
    std::set<std::string> inputs;
    for (const auto* descriptors_of : {&registry.methods, &registry.filters}) {
        for (const MethodDescriptor& one : *descriptors_of) {
            MethodRequest request;
            request.method = &one;
            inputs.merge(needed_gbuffer_inputs(request));
        }
    }
    return inputs;
}

void write_live_file(const std::filesystem::path& folder, const Registry& registry,
                     const std::filesystem::path& methods_dir, const std::map<std::string, LiveView>& views,
                     std::uint64_t seed) {
    json data = {{"contract", contract_data(seed)},
                 {"methods_dir", methods_dir.string()},
                 {"methods", descriptors(registry.methods, seed)},
                 {"filters", descriptors(registry.filters, seed)},
                 {"views", json::object()}};
    for (const auto& [key, view] : views) data["views"][key] = view_data(view, registry);
    write_atomically(folder / kLiveFile, json_text(data) + "\n");
}

}  // namespace aoscore
