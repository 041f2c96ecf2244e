#pragma once

#include "core/parameter_value.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A typed parameter of a method or filter, as its descriptor declares it.
struct Parameter {
    enum class Type { integer, real, boolean, choice };
    std::string id;
    Type type = Type::real;
    ParameterValue default_value;
    double lowest = 0, highest = 0;    ///< integer, real
    std::vector<std::string> choices;  ///< choice: the shader sees the index
    std::string unit;                  ///< "m", "rad", "px", "uv", ""
    std::string meaning;
    int length_power = 0;     ///< power of its scaling with the scene: 1 for lengths, 2 for areas, 0 for none
    std::string signal = {};  ///< the only signal that it affects (core/signal.h); empty: visibility, too
    bool taps = false;        ///< integer: the number of taps is in proportion to it

    /// Whether a value has this parameter's type and lies in its range.
    bool accepts(const ParameterValue& value) const;
    /// The accepted values in words.
    std::string valid() const;
};

/// A table of points that the program generates for a method (seeded, by MethodRequest::seed) and compiles
/// into its shader as `k_<id>[]`. Members that begin with '@' name the parameter that holds the value.
struct Kernel {
    std::string id;
    std::string size;                   ///< number of points: "@samples", or digits
    std::string directions = "sphere";  ///< kernel.h lists the choices
    std::string radii = "shell";
    std::string scale = "none";
    std::string sequence = "random";
};

/// The making of the input "depth_mips" for a method.
struct DepthMips {
    /// "rotated_grid": each texel is one of the four below it (McGuire, Mara, Luebke, Scalable Ambient
    /// Obscurance, 2012); "weighted": their mean, weighted by nearness to the farthest within the radius
    /// (Intel, XeGTAO, 2021).
    std::string filter = "rotated_grid";
    std::string radius_parameter;  ///< "weighted" only
};

/// The settings of an input for a method (see input_members.h): each member is a value, or "@" and the
/// parameter that holds it.
struct InputMembers {
    ParameterValues members;  ///< complete
};

/// The truth that a method claims to approximate: its falloff, and the parameter that holds its radius.
struct OwnTruth {
    std::string falloff = "binary";
    std::string radius_parameter;         ///< empty: infinite
    std::string radius_factor_parameter;  ///< multiplies the radius; empty: 1
    std::string u_parameter;              ///< falloff "alchemy" only
};

/// The AO radius that the lengths among a method's parameters are meant for: the value of a parameter, or a
/// number of metres. Neither where no parameter is a length.
struct ReferenceRadius {
    std::string parameter;
    double metres = 0;
};

/// The filter that follows a method's preset, with the filter's own preset.
struct PresetFilter {
    std::string filter = "none";
    std::string preset = "default";
};

/// A method that is the same over several depth layers, with the preset that reads two.
struct SecondLayer {
    std::string method, preset;
};

/// How a preset was tuned, and what it is worth on scenes that it was not tuned on (see
/// tuning/tuned_method.h). Losses are those of the metric over the views.
struct PresetTuning {
    std::string from;        ///< the preset that it began from
    std::string definition;  ///< id of the file in reports/tunings/; empty for one of the command line
    std::string metric;      ///< what decided
    int views = 0, scenes = 0;
    double published = 0;  ///< the loss of the preset that it began from
    double fitted = 0;     ///< its own on the views that it was tuned on
    std::string left_out;  ///< "scene" or "view"; empty where nothing was left out, as are all below
    std::optional<double> held_out;           ///< the loss on groups of views that were left out
    std::optional<double> change, low, high;  ///< the mean over groups less `published`'s, 95 % interval
};

/// The purpose of a method: to be used in frames, or, as a bound, to show how far others could go, at no
/// usable cost.
enum class MethodRole { method, bound };

/// The presets and modes of a method in a score where the user chooses none.
struct ScoredAs {
    std::vector<std::string> presets = {"default"};
    std::map<std::string, std::string> modes;  ///< mode of running -> choice, such as "resolution": "half"
};

struct Pass {
    std::string fragment;             ///< file in the method's folder; empty where a processor computes it
    std::string processor;            ///< a row of processors(), which computes it from the listed inputs
    std::vector<std::string> inputs;  ///< contract inputs it samples: "linear_depth", "normal_geometric", …
    /// The pass is drawn at 1/scale of the picture's width and height. The next pass reads its result as
    /// "coarser" (a filter's as "visibility"); the last pass has scale 1.
    int scale = 1;
    /// Signals beside visibility that the pass writes where they are asked for; only a method's last pass has
    /// some.
    std::vector<std::string> outputs;
};

/// A method (or filter): a folder of shaders/methods/ (or shaders/filters/) with method.json and GLSL passes.
/// Adding one needs no C++.
struct MethodDescriptor {
    std::string id;  ///< the folder's name
    std::string label;
    MethodRole role = MethodRole::method;
    std::string paper;                    ///< author, title, year
    std::string summary;                  ///< one line
    std::vector<std::string> deviations;  ///< deviations from the paper, a sentence each
    /// The reasons why it breaks by its nature, by stress axis, a sentence each.
    std::map<std::string, std::string> limits;
    std::vector<Parameter> parameters;
    std::map<std::string, ParameterValues> presets;      ///< by id; "default" always exists
    std::map<std::string, PresetFilter> preset_filters;  ///< by preset; none where the descriptor names none
    ReferenceRadius reference_radius;
    /// Presets whose lengths are metres, whatever the AO radius of a run, with the place where they are
    /// printed.
    std::map<std::string, std::string> absolute_presets;
    std::map<std::string, PresetTuning> tunings;  ///< by preset, for those that `aoscore tune` has found
    std::optional<SecondLayer> second_layer;      ///< empty where there is none
    std::vector<Kernel> kernels;
    DepthMips depth_mips;
    std::optional<InputMembers> depth_layers, side_layers;  ///< set where a pass lists the input
    std::vector<Pass> passes;
    OwnTruth truth;
    ScoredAs scored;
    std::filesystem::path folder;

    /// The label in results and on pages, where a bound's says that it is one: "Ray march (bound)".
    std::string shown_label() const;

    /// The parameter of that id, null when there is none.
    const Parameter* find_parameter(std::string_view parameter) const;

    /// Whether it gives this signal.
    bool gives(std::string_view signal) const;

    /// The filter that follows this preset.
    PresetFilter filter_of(const std::string& preset) const;

    /// Every parameter's value: the preset's over the defaults, `overrides` over both. Throws usage_error for
    /// an unknown preset or parameter, or a value out of type or range.
    ParameterValues values(std::string_view preset, const ParameterValues& overrides = {}) const;
};

/// The values that affect visibility.
ParameterValues visibility_values(const MethodDescriptor& method, ParameterValues values);

/// Loads all methods, those of shaders/methods/ and of `extra_dir` (empty: none), by id. Throws file_error
/// for a bad descriptor and for an id that exists twice.
std::vector<MethodDescriptor> load_methods(const std::filesystem::path& extra_dir = {});
/// Loads methods for a user who named those of `asked`: a folder of `extra_dir` that cannot be loaded is an
/// error where it was named; else it is left out, and `warnings` gets a sentence about it.
std::vector<MethodDescriptor> load_asked_methods(const std::filesystem::path& extra_dir,
                                                 const std::vector<std::string>& asked,
                                                 std::vector<std::string>& warnings);
/// The file of a method's folder with presets that were tuned for it, in the form of add_presets().
inline constexpr const char* kTunedPresets = "tuned.json";

/// The presets that a file adds to a method.
struct AddedPresets {
    std::string method;
    std::vector<std::string> presets;
};
/// Adds the presets of a file to the method of `methods` that it names: `method`, and `presets`,
/// `preset_filters` and `absolute_presets` as in a descriptor, and `tunings`. Throws file_error for another
/// form, an unknown method, and a preset that the method has already and that was not tuned.
AddedPresets add_presets(std::vector<MethodDescriptor>& methods, const std::filesystem::path& file);
/// Loads all filters of shaders/filters/. "none" is not among them.
std::vector<MethodDescriptor> load_filters();
/// Loads the pass that costs are related to: sixteen neighbouring depth fetches a pixel, over the whole
/// picture. It is not among the methods.
MethodDescriptor load_fixed_pass();
/// Loads the pass that lights a frame: ambient light times the filtered visibility, and some lights. It is
/// not among the methods.
MethodDescriptor load_lighting();
/// The method of that id. Throws usage_error listing the known ones.
const MethodDescriptor& find_method(const std::vector<MethodDescriptor>& methods, std::string_view id);

}  // namespace aoscore
