#include "page/live/live_index.h"

#include "core/error.h"
#include "core/image.h"
#include "core/strict_json.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

constexpr double kAny = std::numeric_limits<double>::max();
constexpr int kMost = std::numeric_limits<int>::max();
constexpr std::size_t kNoiseNumbers = 4 * 4 * 4;

void require(bool good, const json& value, const std::string& where, const char* valid) {
    if (!good) throw file_error(std::string("is ") + value.type_name(), where, valid);
}

bool is_plain(const json& value) {
    return value.is_number() || value.is_boolean() || value.is_string();
}

/// Checks members of any name, which must be numbers, texts, true or false.
void check_values(StrictObject values) {
    for (const auto& [id, value] : values.members())
        require(is_plain(value), value, values.where(id), "a number, a text, true or false");
}

void check_texts(StrictObject texts) {
    for (const auto& [id, value] : texts.members())
        require(value.is_string(), value, texts.where(id), "a text");
}

/// Checks the values of parameters of each preset.
void check_presets(StrictObject presets) {
    for (const auto& [id, values] : presets.members()) check_values(StrictObject(values, presets.where(id)));
}

void check_contract(StrictObject contract) {
    contract.text("screen_vertex");
    check_texts(contract.object("derived"));
    contract.numbers("noise_4x4", kNoiseNumbers);
    check_values(contract.object("macros"));
    contract.integer("depth_mip_levels", 1, 32);
    check_texts(contract.object("layer_samplings"));
    contract.number("seed", 0, std::numeric_limits<std::uint32_t>::max());
    contract.finish();
}

void check_parameter(StrictObject parameter) {
    for (const char* key : {"id", "unit", "meaning"}) parameter.text(key);
    const std::string type = parameter.text("type");
    const json& preset = parameter.raw("default");
    require(is_plain(preset), preset, parameter.where("default"), "a number, a text, true or false");
    parameter.integer("length_power", -6, 6);
    if (type == "integer" || type == "real") {
        for (const char* key : {"low", "high"}) parameter.number(key, -kAny, kAny);
    } else if (type == "choice") {
        if (parameter.texts_or_empty("choices").empty())
            throw file_error("is empty", parameter.where("choices"), "at least one choice");
    } else if (type != "boolean") {
        throw file_error("is " + type, parameter.where("type"), "integer, real, boolean, choice");
    }
    parameter.finish();
}

void check_kernel(StrictObject kernel) {
    for (const char* key : {"id", "size", "scale"}) kernel.text(key);
    const auto numbers = 3 * static_cast<std::size_t>(kernel.integer("largest", 1, kMost / 3));
    for (StrictObject& table : kernel.objects("tables")) {
        check_values(table.object("when"));
        table.numbers("points", numbers);
        table.finish();
    }
    kernel.finish();
}

/// Checks the members of a layered input, where the method has it; the `needed` ones decide whether the page
/// can run it.
void check_layers(StrictObject& method, const char* input, std::initializer_list<const char*> needed) {
    if (!method.has(input)) return;
    StrictObject members = method.object(input);
    for (const char* member : needed) {
        if (!members.has(member))
            throw file_error("is missing", members.where(member), "a value, or '@' and a parameter");
    }
    check_values(std::move(members));
}

void check_passes(StrictObject& method) {
    const int sources = static_cast<int>(method.texts_or_empty("sources").size());
    std::vector<StrictObject> passes = method.objects("passes");
    if (passes.empty()) throw file_error("is empty", method.where("passes"), "at least one pass");
    for (StrictObject& pass : passes) {
        pass.raw("inputs");  // must be there, even if empty
        pass.texts_or_empty("inputs");
        pass.integer("scale", 1, 64);
        pass.integer("source", 0, sources - 1);
        pass.finish();
    }
    for (StrictObject& kernel : method.objects("kernels")) check_kernel(std::move(kernel));
    StrictObject mips = method.object("depth_mips");
    for (const char* key : {"filter", "radius"}) mips.text(key);
    mips.finish();
    check_layers(method, "depth_layers", {"sampling"});
    check_layers(method, "side_layers", {"cameras", "sampling"});
}

void check_preset_filters(StrictObject filters) {
    for (const auto& [preset, own] : filters.members()) {
        StrictObject filter(own, filters.where(preset));
        for (const char* key : {"filter", "preset"}) filter.text(key);
        filter.finish();
    }
}

void check_method(StrictObject method) {
    for (const char* key : {"id", "label", "summary"}) method.text(key);
    for (StrictObject& parameter : method.objects("parameters")) check_parameter(std::move(parameter));
    check_presets(method.object("presets"));
    check_preset_filters(method.object("preset_filters"));
    check_texts(method.object("absolute_presets"));
    if (method.has("processor"))
        method.text("processor");
    else
        check_passes(method);
    method.finish();
}

/// Checks the lengths by preset of each method or filter that has some.
void check_lengths(StrictObject lengths) {
    for (const auto& [id, presets] : lengths.members())
        check_presets(StrictObject(presets, lengths.where(id)));
}

void check_view(StrictObject view) {
    for (const char* key : {"own_parameters", "orthographic", "surfaces"}) {
        const json& value = view.raw(key);
        require(value.is_boolean(), value, view.where(key), "true or false");
    }
    check_lengths(view.object("method_lengths"));
    check_lengths(view.object("filter_lengths"));
    for (const char* key : {"width", "height"}) view.integer(key, 1, kLargestImageSide_px);
    for (const char* key : {"near_m", "far_m"}) view.number(key, 0, kAny);
    view.numbers("pixel_size", 2);
    view.finish();
}

}  // namespace

void check_live_index(const json& index, const std::string& name) {
    StrictObject top = StrictObject::of_file(index, name);
    check_contract(top.object("contract"));
    top.text("methods_dir");
    for (const char* list : {"methods", "filters"}) {
        for (StrictObject& method : top.objects(list)) check_method(std::move(method));
    }
    StrictObject views = top.object("views");
    for (const auto& [key, view] : views.members()) check_view(StrictObject(view, views.where(key)));
    top.finish();
}

}  // namespace aoscore
