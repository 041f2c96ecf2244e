#include "core/error.h"
#include "core/folders.h"
#include "core/known_names.h"
#include "core/printable.h"
#include "core/signal.h"
#include "core/strict_json.h"
#include "screen/method/input_members.h"
#include "screen/method/kernel.h"
#include "screen/method/method.h"
#include "screen/method/method_files.h"
#include "screen/method/preset_tuning.h"
#include "screen/method/side_layers.h"
#include "screen/passes/processors.h"
#include "screen/passes/shader_source.h"
#include "screen/screen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <set>

namespace aoscore {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void check_id(const std::string& id, const std::string& where, char separator) {
    const bool good = !id.empty() && std::islower(static_cast<unsigned char>(id[0])) != 0 &&
                      std::all_of(id.begin(), id.end(), [&](unsigned char c) {
                          return std::islower(c) != 0 || std::isdigit(c) != 0 || c == separator;
                      });
    if (!good) {
        throw file_error(fmt::format("\"{}\" is no id", id), where,
                         fmt::format("lower-case letters, digits and '{}', a letter first", separator));
    }
}

Parameter::Type parse_type(const std::string& name, const std::string& where) {
    if (name == "integer") return Parameter::Type::integer;
    if (name == "real") return Parameter::Type::real;
    if (name == "boolean") return Parameter::Type::boolean;
    if (name == "choice") return Parameter::Type::choice;
    throw file_error(fmt::format("is \"{}\"", name), where, "integer, real, boolean, choice");
}

Parameter parse_parameter(const std::string& id, StrictObject object) {
    Parameter p;
    p.id = id;
    check_id(id, object.where(), '_');
    p.type = parse_type(object.text("type"), object.where("type"));
    p.meaning = object.text("meaning");
    p.unit = object.text_or("unit", "");
    p.length_power = object.integer_or("length_power", 0, -6, 6);
    p.signal = object.text_or("signal", "");
    const std::vector<std::string> known = further_signals();
    if (!p.signal.empty() && std::ranges::find(known, p.signal) == known.end())
        throw unknown_name_in_file(p.signal, known, object.where("signal"));
    if (p.type == Parameter::Type::integer || p.type == Parameter::Type::real) {
        const auto range = object.numbers("range", 2);
        p.lowest = range[0];
        p.highest = range[1];
        // The largest integer of GLSL.
        constexpr double kLargestInteger = std::numeric_limits<int>::max();
        constexpr double kLargestReal = std::numeric_limits<float>::max();
        const double largest = p.type == Parameter::Type::integer ? kLargestInteger : kLargestReal;
        if (p.lowest < -largest || p.highest > largest || p.lowest > p.highest) {
            throw file_error(fmt::format("is {} to {}", p.lowest, p.highest), object.where("range"),
                             fmt::format("lowest and highest, from {} to {}", -largest, largest));
        }
    } else if (p.type == Parameter::Type::choice) {
        p.choices = object.texts_or_empty("choices");
        for (const std::string& choice : p.choices) check_id(choice, object.where("choices"), '_');
    }
    p.taps = object.boolean_or("taps", false);
    if (p.taps && p.type != Parameter::Type::integer)
        throw file_error("is no integer", object.where("taps"), "integers alone");
    if (p.length_power != 0 && p.type != Parameter::Type::real)
        throw file_error("is no real number", object.where("length_power"), "real parameters alone");
    p.default_value = parameter_value(object.raw("default"), object.where("default"));
    if (!p.accepts(p.default_value)) {
        throw file_error(fmt::format("is {}", p.default_value.quoted()), object.where("default"), p.valid());
    }
    object.finish();
    return p;
}

std::map<std::string, ParameterValues> parse_presets(const MethodDescriptor& method, StrictObject presets) {
    std::map<std::string, ParameterValues> result;
    for (const auto& [name, value] : presets.members()) {
        check_id(name, presets.where(name), '-');
        for (const auto& [id, stated] : StrictObject(value, presets.where(name)).members()) {
            const std::string where = presets.where(name) + "." + id;
            const Parameter* parameter = method.find_parameter(id);
            if (parameter == nullptr) throw file_error("is no parameter", where, "a declared parameter");
            const ParameterValue setting = parameter_value(stated, where);
            if (!parameter->accepts(setting)) {
                throw file_error(fmt::format("is {}", setting.quoted()), where, parameter->valid());
            }
            result[name][id] = setting;
        }
        result.try_emplace(name);
    }
    return result;
}

// Reads a member of a kernel: one of the known words, or '@' and a choice parameter all of whose choices are
// known words.
std::string kernel_member(StrictObject& object, const char* key, const std::string& fallback,
                          const std::set<std::string>& known, const MethodDescriptor& method) {
    std::string value = object.text_or(key, fallback);
    if (value.starts_with('@')) {
        const Parameter* p = method.find_parameter(value.substr(1));
        const bool good = p != nullptr && p->type == Parameter::Type::choice &&
                          std::all_of(p->choices.begin(), p->choices.end(),
                                      [&](const auto& c) { return known.contains(c); });
        if (good) return value;
    } else if (known.contains(value)) {
        return value;
    }
    throw file_error(fmt::format("is \"{}\"", value), object.where(key),
                     fmt::format("{}; or @ and a choice parameter of these", fmt::join(known, ", ")));
}

/// The points of a kernel may be uniforms, of which OpenGL 3.3 promises 1024 numbers and llvmpipe has 16384.
constexpr int kMostKernelPoints = 2048;

Kernel parse_kernel(const std::string& id, StrictObject object, const MethodDescriptor& method) {
    Kernel kernel;
    kernel.id = id;
    check_id(id, object.where(), '_');
    const json& size = object.raw("size");
    if (size.is_number()) {
        kernel.size = std::to_string(object.integer("size", 1, kMostKernelPoints));
    } else if (size.is_string() && size.get<std::string>().starts_with('@')) {
        kernel.size = size.get<std::string>();
        const Parameter* p = method.find_parameter(kernel.size.substr(1));
        if (p == nullptr || p->type != Parameter::Type::integer || p->lowest < 1 ||
            p->highest > kMostKernelPoints) {
            throw file_error(
                fmt::format("is \"{}\"", kernel.size), object.where("size"),
                fmt::format("@ and an integer parameter in the range of 1 to {}", kMostKernelPoints));
        }
    } else {
        throw file_error(fmt::format("is {}", size.dump()), object.where("size"),
                         "a count, or @ and an integer parameter");
    }
    kernel.directions =
        kernel_member(object, "directions", kernel.directions, KernelChoices::directions(), method);
    kernel.radii = kernel_member(object, "radii", kernel.radii, KernelChoices::radii(), method);
    kernel.scale = kernel_member(object, "scale", kernel.scale, KernelChoices::scales(), method);
    kernel.sequence = kernel_member(object, "sequence", kernel.sequence, KernelChoices::sequences(), method);
    object.finish();
    return kernel;
}

DepthMips parse_depth_mips(const MethodDescriptor& method, StrictObject object) {
    DepthMips mips;
    mips.filter = object.text("filter");
    if (mips.filter != "rotated_grid" && mips.filter != "weighted") {
        throw file_error(fmt::format("is \"{}\"", mips.filter), object.where("filter"),
                         "rotated_grid, weighted");
    }
    if (mips.filter == "weighted") {
        mips.radius_parameter = object.text("radius");
        const Parameter* p = method.find_parameter(mips.radius_parameter);
        if (p == nullptr || p->type != Parameter::Type::real) {
            throw file_error(fmt::format("is \"{}\"", mips.radius_parameter), object.where("radius"),
                             "a real parameter");
        }
    }
    object.finish();
    return mips;
}

OwnTruth parse_truth(const MethodDescriptor& method, StrictObject object) {
    OwnTruth truth;
    truth.falloff = object.text_or("falloff", truth.falloff);
    truth.radius_parameter = object.text_or("radius", "");
    truth.radius_factor_parameter = object.text_or("radius_factor", "");
    truth.u_parameter = object.text_or("u", "");
    for (const auto& [key, id] :
         {std::pair("radius", truth.radius_parameter),
          std::pair("radius_factor", truth.radius_factor_parameter), std::pair("u", truth.u_parameter)}) {
        if (!id.empty() && method.find_parameter(id) == nullptr) {
            throw file_error(fmt::format("is \"{}\"", id), object.where(key), "a declared parameter");
        }
    }
    if (truth.radius_parameter.empty() && !truth.radius_factor_parameter.empty()) {
        throw file_error("multiplies no radius", object.where("radius_factor"), "radius beside it");
    }
    object.finish();
    return truth;
}

/// Reads the signals that a pass writes beside visibility.
std::vector<std::string> parse_outputs(const Pass& pass, const fs::path& folder, StrictObject& object) {
    const std::vector<std::string> outputs = object.texts_or_empty("outputs"), known = further_signals();
    if (outputs.empty()) return outputs;
    if (!pass.processor.empty()) throw file_error("is given to a processor's pass", object.where("outputs"));
    const std::string text = expanded_text(folder / pass.fragment, folder);
    for (const std::string& output : outputs) {
        if (std::ranges::find(known, output) == known.end())
            throw unknown_name_in_file(output, known, object.where("outputs"));
        if (!mentions(text, "o_" + output))
            throw file_error("is never written, as o_" + output, object.where("outputs"));
    }
    return outputs;
}

Pass parse_pass(StrictObject object, const fs::path& folder, const std::set<std::string>& inputs) {
    Pass pass;
    pass.processor = object.text_or("processor", "");
    if (!pass.processor.empty()) row_in_file(processors(), pass.processor, object.where("processor"));
    if (pass.processor.empty()) pass.fragment = object.text("fragment");
    if (pass.processor.empty() && !fs::is_regular_file(folder / pass.fragment)) {
        throw file_error(fmt::format("\"{}\" is not there", pass.fragment), object.where("fragment"),
                         "a file of the folder");
    }
    if (pass.processor.empty()) require_own_file(folder / pass.fragment, folder, object.where("fragment"));
    pass.inputs = object.texts_or_empty("inputs");
    for (const std::string& input : pass.inputs) {
        if (!inputs.contains(input)) {
            throw file_error(fmt::format("asks for \"{}\"", input), object.where("inputs"),
                             fmt::format("{}", fmt::join(inputs, ", ")));
        }
    }
    pass.scale = object.integer_or("scale", 1, 1, 64);
    pass.outputs = parse_outputs(pass, folder, object);
    object.finish();
    return pass;
}

ReferenceRadius parse_reference_radius(const MethodDescriptor& method, StrictObject& top) {
    constexpr const char* kKey = "reference_radius";
    std::vector<std::string> lengths;
    for (const Parameter& p : method.parameters) {
        if (p.length_power != 0) lengths.push_back(p.id);
    }
    if (lengths.empty() && !top.has(kKey)) return {};
    constexpr const char* kValid =
        "the parameter that is the radius (real, length_power 1), or metres above 0";
    if (lengths.empty()) throw file_error("no parameter has a length_power", top.where(kKey));
    if (!top.has(kKey)) {
        throw file_error(fmt::format("is missing: no AO radius is named that the default of {} is meant for",
                                     fmt::join(lengths, ", ")),
                         top.where(kKey), kValid);
    }
    const json& value = top.raw(kKey);
    if (value.is_number() && value.get<double>() > 0) return {"", value.get<double>()};
    const Parameter* p = value.is_string() ? method.find_parameter(value.get<std::string>()) : nullptr;
    if (p == nullptr || p->length_power != 1 || p->lowest <= 0)
        throw file_error(fmt::format("is {}", value.dump()), top.where(kKey), kValid);
    return {p->id, 0};
}

PresetFilter parse_preset_filter(const json& value, const std::string& where) {
    if (value.is_string()) return {value.get<std::string>(), "default"};
    if (!value.is_object())
        throw file_error("has another form", where, "a filter's id, or an object of filter and preset");
    StrictObject object(value, where + ".");
    const PresetFilter parsed{object.text("filter"), object.text("preset")};
    object.finish();
    return parsed;
}

void parse_preset_filters(StrictObject& top, MethodDescriptor& method) {
    if (!top.has("preset_filters")) return;
    StrictObject filters = top.object("preset_filters");
    for (const auto& [preset, filter] : filters.members()) {
        if (!method.presets.contains(preset)) throw file_error("is no preset", filters.where(preset));
        method.preset_filters[preset] = parse_preset_filter(filter, filters.where(preset));
    }
}

std::map<std::string, std::string> parse_absolute_presets(const MethodDescriptor& method,
                                                          StrictObject presets) {
    std::map<std::string, std::string> absolute;
    for (const auto& [preset, reason] : presets.members()) {
        if (!method.presets.contains(preset)) throw file_error("is no preset", presets.where(preset));
        if (!reason.is_string() || reason.get<std::string>().empty())
            throw file_error("has another form", presets.where(preset), "where its lengths are printed");
        absolute[preset] = reason.get<std::string>();
    }
    return absolute;
}

SecondLayer parse_second_layer(StrictObject object) {
    SecondLayer layer{object.text("method"), object.text("preset")};
    object.finish();
    return layer;
}

/// Adds the presets of a file, whose members are as in a descriptor, with how they were tuned; returns their
/// ids. Presets that were tuned give way to those of the file.
std::vector<std::string> add_presets_of(StrictObject& top, MethodDescriptor& method) {
    std::vector<std::string> added;
    for (auto& [preset, values] : parse_presets(method, top.object("presets"))) {
        if (method.presets.contains(preset) && method.tunings.erase(preset) == 0)
            throw file_error("exists already", top.where("presets") + "." + preset, "a name of its own");
        method.presets[preset] = std::move(values);
        method.preset_filters.erase(preset);
        method.absolute_presets.erase(preset);
        added.push_back(preset);
    }
    parse_preset_filters(top, method);
    if (top.has("absolute_presets"))
        method.absolute_presets.merge(parse_absolute_presets(method, top.object("absolute_presets")));
    if (!top.has("tunings")) return added;
    StrictObject tunings = top.object("tunings");
    for (const auto& [preset, tuning] : tunings.members()) {
        if (std::ranges::find(added, preset) == added.end())
            throw file_error("is no preset of this file", tunings.where(preset));
        method.tunings[preset] = parse_tuning(StrictObject(tuning, tunings.where(preset)));
    }
    return added;
}

/// Adds the presets that were tuned for a method, where its folder has some.
void add_tuned_presets(MethodDescriptor& method) {
    const fs::path file = method.folder / kTunedPresets;
    if (!fs::is_regular_file(file)) return;
    require_own_file(file, method.folder, file.string());
    const json parsed = parse_json_file(file);
    StrictObject top = StrictObject::of_file(parsed, file.string());
    // A folder that was copied, to be changed, is another method: what was found for the first is not for it.
    if (top.text("method") != method.id) return;
    add_presets_of(top, method);
    top.finish();
}

std::map<std::string, std::string> parse_limits(StrictObject object) {
    std::map<std::string, std::string> limits;
    for (const auto& [axis, reason] : object.members()) {
        if (!reason.is_string() || reason.get<std::string>().empty())
            throw file_error("has another form", object.where(axis), "a sentence");
        limits[axis] = reason.get<std::string>();
    }
    return limits;
}

/// An input that holds several depths a texel, with its member of the descriptor.
struct LayeredInput {
    const char* id;
    std::optional<InputMembers> MethodDescriptor::*layers;
    const std::vector<Parameter>& (*members)();
};

const std::vector<LayeredInput>& layered_inputs() {
    static const std::vector<LayeredInput> all = {
        {"depth_layers", &MethodDescriptor::depth_layers, &depth_layers_members},
        {"side_layers", &MethodDescriptor::side_layers, &side_layers_members},
    };
    return all;
}

// Checks that every parameter has an effect, since some pass or kernel names it.
void check_parameters_used(const MethodDescriptor& method, const std::string& where) {
    std::string text;
    std::set<std::string> processed;
    for (const Pass& pass : method.passes) {
        if (pass.processor.empty()) {
            text += expanded_text(method.folder / pass.fragment, method.folder);
        } else {
            processed.merge(std::set(row_of(processors(), pass.processor, "no processor").parameters));
        }
    }
    for (const std::string& id : processed) {
        if (method.find_parameter(id) == nullptr) {
            throw file_error("the processor needs the parameter " + id, where + ": parameters");
        }
    }
    for (const Parameter& p : method.parameters) {
        const std::string reference = "@" + p.id;
        const bool in_kernel =
            std::any_of(method.kernels.begin(), method.kernels.end(), [&](const Kernel& k) {
                return k.size == reference || k.directions == reference || k.radii == reference ||
                       k.scale == reference || k.sequence == reference;
            });
        const bool in_layers = std::ranges::any_of(layered_inputs(), [&](const LayeredInput& input) {
            const std::optional<InputMembers>& layers = method.*input.layers;
            return layers && names_parameter(*layers, p.id);
        });
        if (!in_kernel && !in_layers && !processed.contains(p.id) && !mentions(text, "p_" + p.id)) {
            throw file_error(fmt::format("no pass uses the parameter (as p_{})", p.id),
                             where + ": parameters." + p.id);
        }
    }
    for (const Kernel& k : method.kernels) {
        if (!mentions(text, "k_" + k.id)) {
            throw file_error(fmt::format("no pass uses the kernel (as k_{})", k.id),
                             where + ": kernels." + k.id);
        }
    }
}

// Checks that layers of depth are both declared and read, or neither.
void check_layers(const MethodDescriptor& method, const StrictObject& top) {
    for (const LayeredInput& input : layered_inputs()) {
        const bool listed = std::ranges::any_of(method.passes, [&](const Pass& pass) {
            return std::ranges::find(pass.inputs, input.id) != pass.inputs.end();
        });
        const bool declared = (method.*input.layers).has_value();
        if (listed && !declared) {
            throw file_error(fmt::format("is missing, though a pass lists the input {}", input.id),
                             top.where(input.id), "an object that says how they are gathered");
        }
        if (declared && !listed)
            throw file_error(fmt::format("no pass lists the input {}", input.id), top.where(input.id));
    }
}

ScoredAs parse_scored(const MethodDescriptor& method, StrictObject object) {
    ScoredAs scored;
    if (object.has("presets")) {
        scored.presets = object.texts_or_empty("presets");
        if (scored.presets.empty())
            throw file_error("is empty", object.where("presets"), "at least one preset");
        for (const std::string& preset : scored.presets) {
            if (!method.presets.contains(preset)) {
                throw file_error(fmt::format("\"{}\" is no preset", preset), object.where("presets"));
            }
        }
    }
    if (object.has("modes")) {
        StrictObject modes = object.object("modes");
        for (const auto& [mode, choice] : modes.members()) scored.modes[mode] = modes.text(mode);
    }
    object.finish();
    return scored;
}

MethodRole parse_role(const std::string& name, const std::string& where) {
    if (name == "method") return MethodRole::method;
    if (name == "bound") return MethodRole::bound;
    throw file_error(fmt::format("is \"{}\"", name), where, "method, bound");
}

MethodDescriptor load_descriptor(const fs::path& folder, const std::set<std::string>& inputs,
                                 bool is_filter) {
    const fs::path file = folder / "method.json";
    const std::string where = file.string();
    require_own_file(file, folder, where);
    const json parsed = parse_json_file(file);
    StrictObject top = StrictObject::of_file(parsed, where);
    MethodDescriptor method;
    method.folder = folder;
    method.id = folder.filename().string();
    check_id(method.id, where, '-');
    method.label = top.text("label");
    if (!is_filter) method.role = parse_role(top.text_or("role", "method"), top.where("role"));
    method.paper = top.text("paper");
    method.summary = top.text("summary");
    method.deviations = top.texts_or_empty("deviations");
    if (top.has("limits")) method.limits = parse_limits(top.object("limits"));
    if (top.has("parameters")) {
        StrictObject parameters = top.object("parameters");
        for (const auto& [id, value] : parameters.members()) {
            method.parameters.push_back(parse_parameter(id, StrictObject(value, parameters.where(id))));
        }
    }
    if (top.has("presets")) method.presets = parse_presets(method, top.object("presets"));
    method.presets.try_emplace("default");
    if (!is_filter) parse_preset_filters(top, method);
    method.reference_radius = parse_reference_radius(method, top);
    if (!is_filter && top.has("absolute_presets"))
        method.absolute_presets = parse_absolute_presets(method, top.object("absolute_presets"));
    if (top.has("kernels")) {
        StrictObject kernels = top.object("kernels");
        for (const auto& [id, value] : kernels.members()) {
            method.kernels.push_back(parse_kernel(id, StrictObject(value, kernels.where(id)), method));
        }
    }
    if (top.has("depth_mips")) method.depth_mips = parse_depth_mips(method, top.object("depth_mips"));
    for (const LayeredInput& input : layered_inputs()) {
        if (top.has(input.id))
            method.*input.layers = parse_input_members(method, top.object(input.id), input.members());
    }
    for (const StrictObject& pass : top.objects("passes"))
        method.passes.push_back(parse_pass(pass, folder, inputs));
    if (method.passes.empty()) throw file_error("is empty", top.where("passes"), "at least one pass");
    if (method.passes.back().scale != 1)
        throw file_error("the last pass has a scale", top.where("passes"), "scale 1");
    for (const Pass& pass : method.passes) {
        if (!pass.outputs.empty() && (is_filter || &pass != &method.passes.back()))
            throw file_error("only the last pass of a method has outputs", top.where("passes"));
    }
    check_layers(method, top);
    if (!is_filter && top.has("truth")) method.truth = parse_truth(method, top.object("truth"));
    if (!is_filter && top.has("second_layer"))
        method.second_layer = parse_second_layer(top.object("second_layer"));
    if (!is_filter) add_tuned_presets(method);
    if (!is_filter && top.has("scored")) method.scored = parse_scored(method, top.object("scored"));
    top.finish();
    check_parameters_used(method, where);
    return method;
}

/// The folders of a folder that are not hidden, by name.
std::vector<fs::path> folders_in(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw file_error("is no folder", folder.string());
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory() && !entry.path().filename().string().starts_with('.'))
            folders.push_back(entry.path());
    }
    std::ranges::sort(folders);
    return folders;
}

void load_folder(const fs::path& folder, bool is_filter, std::vector<MethodDescriptor>& result) {
    const std::set<std::string>& inputs = is_filter ? filter_inputs() : method_inputs();
    for (const fs::path& one : folders_in(folder)) result.push_back(load_descriptor(one, inputs, is_filter));
}

bool has_id(const std::vector<MethodDescriptor>& methods, const std::string& id) {
    return std::ranges::any_of(methods, [&](const MethodDescriptor& m) { return m.id == id; });
}

std::vector<MethodDescriptor> sorted_unique(std::vector<MethodDescriptor> all) {
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    const auto twice =
        std::adjacent_find(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id == b.id; });
    if (twice != all.end()) {
        throw file_error(fmt::format("\"{}\" exists twice", twice->id), (twice + 1)->folder.string(),
                         "a name that differs from " + twice->folder.string());
    }
    return all;
}

}  // namespace

std::vector<MethodDescriptor> load_methods(const fs::path& extra_dir) {
    std::vector<MethodDescriptor> all;
    load_folder(data_dir() / "shaders" / "methods", false, all);
    if (!extra_dir.empty()) load_folder(extra_dir, false, all);
    return sorted_unique(std::move(all));
}

std::vector<MethodDescriptor> load_asked_methods(const fs::path& extra_dir,
                                                 const std::vector<std::string>& asked,
                                                 std::vector<std::string>& warnings) {
    std::vector<MethodDescriptor> all = load_methods();
    if (extra_dir.empty()) return all;
    std::vector<MethodDescriptor> added;
    for (const fs::path& folder : folders_in(extra_dir)) {
        const std::string id = folder.filename().string();
        try {
            added.push_back(load_descriptor(folder, method_inputs(), false));
            if (has_id(all, id)) {
                added.pop_back();
                throw file_error(fmt::format("\"{}\" exists twice", id), folder.string(),
                                 "a name that no other method has");
            }
        } catch (const Error& e) {
            if (std::ranges::find(asked, id) != asked.end()) throw;
            warnings.push_back(fmt::format("method {} is left out: {}", printable(id), e.what()));
        }
    }
    std::ranges::move(added, std::back_inserter(all));
    return sorted_unique(std::move(all));
}

AddedPresets add_presets(std::vector<MethodDescriptor>& methods, const fs::path& file) {
    const json parsed = parse_json_file(file);
    StrictObject top = StrictObject::of_file(parsed, file.string());
    AddedPresets added{top.text("method"), {}};
    if (!has_id(methods, added.method))
        throw unknown_name_in_file(added.method, ids_of(methods), top.where("method"));
    MethodDescriptor& method =
        *std::ranges::find_if(methods, [&](const MethodDescriptor& m) { return m.id == added.method; });
    added.presets = add_presets_of(top, method);
    top.finish();
    return added;
}

std::vector<MethodDescriptor> load_filters() {
    std::vector<MethodDescriptor> all;
    load_folder(data_dir() / "shaders" / "filters", true, all);
    return sorted_unique(std::move(all));
}

MethodDescriptor load_fixed_pass() {
    return load_descriptor(data_dir() / "shaders" / "fixed_pass" / "sixteen-taps", method_inputs(), false);
}

MethodDescriptor load_lighting() {
    return load_descriptor(data_dir() / "shaders" / "lighting" / "phong", filter_inputs(), true);
}

}  // namespace aoscore
