#include "screen/passes/pass_program.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/signal.h"
#include "image/channels.h"
#include "screen/method/kernel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace aoscore {
namespace {

const std::set<std::string>& contract_uniforms() {
    static const std::set<std::string> all = {
        "u_size_px",      "u_pixel_size",      "u_near",          "u_far", "u_seed",
        "u_side_size_px", "u_side_pixel_size", "u_side_from_view"};
    return all;
}

std::string glsl_number(double value) {
    std::string text = fmt::format("{:.9g}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

int choice_index(const Parameter& p, const ParameterValue& value) {
    const auto found = std::find(p.choices.begin(), p.choices.end(), value.word());
    return static_cast<int>(found - p.choices.begin());
}

std::string_view glsl_type(Parameter::Type type) {
    switch (type) {
        case Parameter::Type::real:
            return "float";
        case Parameter::Type::boolean:
            return "bool";
        default:
            return "int";
    }
}

std::string glsl_value(const Parameter& p, const ParameterValue& value) {
    switch (p.type) {
        case Parameter::Type::integer:
            return std::to_string(static_cast<long long>(value.number()));
        case Parameter::Type::real:
            return glsl_number(value.number());
        case Parameter::Type::boolean:
            return value.boolean() ? "true" : "false";
        case Parameter::Type::choice:
            return std::to_string(choice_index(p, value));
    }
    return {};
}

std::string parameter_block(const PassBuild& build) {
    std::string text;
    for (const Parameter& p : build.method->parameters) {
        for (std::size_t i = 0; i < p.choices.size(); ++i)
            text += fmt::format("const int {}_{} = {};\n", p.id, p.choices[i], i);
        text += build.uniform_form ? fmt::format("uniform {} p_{};\n", glsl_type(p.type), p.id)
                                   : fmt::format("const {} p_{} = {};\n", glsl_type(p.type), p.id,
                                                 glsl_value(p, build.parameters->at(p.id)));
    }
    return text;
}

// The kernel with every '@' replaced by its parameter's value.
Kernel resolved(const Kernel& kernel, const PassBuild& build) {
    Kernel result = kernel;
    for (std::string* member :
         {&result.size, &result.directions, &result.radii, &result.scale, &result.sequence}) {
        if (!member->starts_with('@')) continue;
        const ParameterValue& value = build.parameters->at(member->substr(1));
        *member = value.is_word() ? value.word() : std::to_string(static_cast<long long>(value.number()));
    }
    return result;
}

// The declared size of a kernel's array, which in the uniform form is the largest, so that one program serves
// every setting.
std::size_t declared_size(const Kernel& kernel, const PassBuild& build) {
    if (!kernel.size.starts_with('@')) return std::stoul(kernel.size);
    return static_cast<std::size_t>(build.method->find_parameter(kernel.size.substr(1))->highest);
}

std::string kernel_block(const PassBuild& build) {
    std::string text;
    for (const Kernel& kernel : build.method->kernels) {
        if (build.uniform_form) {
            text += fmt::format("uniform vec3 k_{}[{}];\n", kernel.id, declared_size(kernel, build));
            continue;
        }
        std::vector<std::string> points;
        for (const glm::vec3& p : generate_kernel(resolved(kernel, build), build.seed)) {
            points.push_back(
                fmt::format("vec3({}, {}, {})", glsl_number(p.x), glsl_number(p.y), glsl_number(p.z)));
        }
        text += fmt::format("const vec3 k_{}[{}] = vec3[{}](\n    {});\n", kernel.id, points.size(),
                            points.size(), fmt::join(points, ",\n    "));
    }
    return text;
}

std::string macro_block(const PassBuild& build) {
    std::string text;
    for (const auto& [name, value] : pass_macros(build)) text += fmt::format("#define {} {}\n", name, value);
    return text + mirror_macros(build.mirror);
}

std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// The outputs of the signals beside visibility, which a shader finds by `#ifdef SIGNAL_<ID>`.
std::string output_block(const PassBuild& build) {
    std::string text;
    for (std::size_t i = 0; i < build.signals.size(); ++i) {
        const std::size_t components = signal(build.signals[i]).channels.size();
        const std::string type = components == 1 ? "float" : fmt::format("vec{}", components);
        text += fmt::format("#define SIGNAL_{}\nlayout(location = {}) out {} o_{};\n",
                            upper_case(build.signals[i]), i + 1, type, build.signals[i]);
    }
    return text;
}

void add_body(ShaderSource& source, const PassBuild& build, const Pass& pass) {
    source.add_block(fmt::format("({}: parameters)", build.method->id), parameter_block(build));
    source.add_block(fmt::format("({}: kernels)", build.method->id), kernel_block(build));
    // Loops over all depths of a texel would multiply the length of unrolled code, and take the compiler
    // minutes.
    if (!build.uniform_form && !build.method->depth_layers && !build.method->side_layers) {
        std::map<std::string, int> counts;
        for (const Parameter& p : build.method->parameters) {
            if (p.type == Parameter::Type::integer)
                counts["p_" + p.id] = static_cast<int>(build.parameters->at(p.id).number());
        }
        source.unroll(std::move(counts));
    }
    source.add_file(build.method->folder / pass.fragment, build.method->folder);
}

bool is_sampler(GLenum type) {
    return type == GL_SAMPLER_2D || type == GL_SAMPLER_2D_ARRAY;
}

}  // namespace

const std::set<std::string>& method_inputs() {
    static const std::set<std::string> all = [] {
        std::set<std::string> inputs = gbuffer_inputs();
        for (const MadeInput& made : made_inputs()) {
            if (!made.filters_only) inputs.emplace(made.id);
        }
        return inputs;
    }();
    return all;
}

const std::set<std::string>& filter_inputs() {
    static const std::set<std::string> all = [] {
        std::set<std::string> inputs = method_inputs();
        for (const MadeInput& made : made_inputs()) inputs.emplace(made.id);
        return inputs;
    }();
    return all;
}

std::map<std::string, int> pass_macros(const PassBuild& build) {
    std::map<std::string, int> macros{{"ORTHOGRAPHIC", build.orthographic ? 1 : 0},
                                      {"BORDER_FAR", build.border_far ? 1 : 0},
                                      {"SCALE", build.scale},
                                      {"COARSER_SCALE", build.coarser_scale},
                                      {"HALF_TAPS", build.half_taps ? 1 : 0},
                                      {"DUAL", build.dual ? 1 : 0},
                                      {"COUNT_FETCHES", build.count_fetches ? 1 : 0}};
    if (build.positions) macros["STORED_POSITIONS"] = 1;
    return macros;
}

std::string mirror_macros(Mirror mirror) {
    switch (mirror) {
        case Mirror::none:
            return "";
        case Mirror::left_right:
            return "#define MIRROR_X -1\n";
        case Mirror::up_down:
            return "#define MIRROR_Y -1\n";
    }
    return "";
}

ShaderSource screen_vertex() {
    ShaderSource source;
    const auto folder = data_dir() / "shaders" / "gbuffer";
    source.add_file(folder / "screen.vert", folder);
    return source;
}

ShaderSource pass_source(const PassBuild& build, const Pass& pass) {
    ShaderSource source;
    source.add_block("(program's macros)", macro_block(build));
    if (!build.signals.empty()) source.add_block("(program's outputs)", output_block(build));
    add_body(source, build, pass);
    return source;
}

ShaderSource pass_source_without_macros(const PassBuild& build, const Pass& pass) {
    ShaderSource source;
    add_body(source, build, pass);
    return source;
}

PassProgram::PassProgram(const PassBuild& build, const Pass& pass, const ShaderSource& fragment)
    : program_(fmt::format("{}/{}", build.method->id, pass.fragment), screen_vertex(), fragment) {
    const std::string where = (build.method->folder / "method.json").string() + ": " + pass.fragment;
    for (const auto& [name, uniform] : program_.uniforms()) {
        if (contract_uniforms().contains(name)) continue;
        if (is_sampler(uniform.type)) {
            const std::string input = name.starts_with("u_") ? name.substr(2) : name;
            // Inputs that only a resolution mode reads belong to the program, not to the method.
            if ((build.dual && input == "coarser") || (build.half_taps && input == "half_depth")) {
                samplers_.push_back(input);
                continue;
            }
            if (std::find(pass.inputs.begin(), pass.inputs.end(), input) == pass.inputs.end()) {
                throw file_error(fmt::format("samples {}, which is not among the pass's inputs", name), where,
                                 fmt::format("u_{}", fmt::join(pass.inputs, ", u_")));
            }
            samplers_.push_back(input);
            continue;
        }
        const bool parameter = build.uniform_form && name.starts_with("p_") &&
                               build.method->find_parameter(name.substr(2)) != nullptr;
        const bool kernel = build.uniform_form && name.starts_with("k_");
        if (!parameter && !kernel) {
            throw file_error(
                fmt::format("uses the uniform {}, which is neither the contract's nor a parameter", name),
                where, fmt::format("{}", fmt::join(contract_uniforms(), ", ")));
        }
    }
}

void PassProgram::set_parameters(const PassBuild& build) const {
    for (const Parameter& p : build.method->parameters) {
        const GLint location = program_.location("p_" + p.id);
        const ParameterValue& value = build.parameters->at(p.id);
        switch (p.type) {
            case Parameter::Type::real:
                gl::Uniform1f(location, static_cast<float>(value.number()));
                break;
            case Parameter::Type::boolean:
                gl::Uniform1i(location, value.boolean() ? 1 : 0);
                break;
            case Parameter::Type::integer:
                gl::Uniform1i(location, static_cast<GLint>(value.number()));
                break;
            case Parameter::Type::choice:
                gl::Uniform1i(location, choice_index(p, value));
                break;
        }
    }
    for (const Kernel& kernel : build.method->kernels) {
        const auto points = generate_kernel(resolved(kernel, build), build.seed);
        // The compiler may have shortened a uniform array to the elements in use.
        const auto found = program_.uniforms().find("k_" + kernel.id);
        if (found == program_.uniforms().end()) continue;
        const GLsizei count = std::min(static_cast<GLsizei>(points.size()), found->second.size);
        gl::Uniform3fv(found->second.location, count, &points[0].x);
    }
}

}  // namespace aoscore
