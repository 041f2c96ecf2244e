#pragma once

#include "screen/gl/shader_program.h"
#include "screen/method/method.h"
#include "screen/screen.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace aoscore {

/// Everything that decides the shader of a pass.
struct PassBuild {
    const MethodDescriptor* method = nullptr;
    const ParameterValues* parameters = nullptr;  ///< complete
    std::uint64_t seed = 1;
    bool orthographic = false;
    bool border_far = true;      ///< whether taps outside of the picture read the far plane
    int scale = 1;               ///< the pass's: its pixel stands for scale x scale of the picture
    int coarser_scale = 1;       ///< the scale of the pass before it
    bool half_taps = false;      ///< taps read a G-buffer of half the resolution
    bool dual = false;           ///< shades only where the coarse result varies
    bool positions = false;      ///< positions are stored in place of depth
    bool uniform_form = false;   ///< parameters and kernels as uniforms, not constants
    bool count_fetches = false;  ///< with the second output o_fetches
    Mirror mirror = Mirror::none;
    std::vector<std::string> signals;  ///< signals beside visibility, written as o_<id>
};

/// The macros that a pass is compiled with, by name.
std::map<std::string, int> pass_macros(const PassBuild& build);

/// The definitions that mirror a shader's randomness; none where nothing is mirrored.
std::string mirror_macros(Mirror mirror);

/// The vertex shader of every pass: one triangle over the screen.
ShaderSource screen_vertex();
/// The fragment shader of a pass: macros, parameters, kernels, then the method's own file.
ShaderSource pass_source(const PassBuild& build, const Pass& pass);
/// The fragment shader without the macros, for programs that add their own.
ShaderSource pass_source_without_macros(const PassBuild& build, const Pass& pass);

/// A pass's program, checked against its descriptor.
class PassProgram {
  public:
    /// Throws file_error for an active uniform that is neither the contract's nor a parameter, and for an
    /// input that is sampled without being listed; internal_error for a shader that does not compile.
    PassProgram(const PassBuild& build, const Pass& pass, const ShaderSource& fragment);

    const ShaderProgram& program() const { return program_; }
    /// The inputs that are actually sampled; sampler `u_<input>` reads texture unit [index].
    const std::vector<std::string>& samplers() const { return samplers_; }

    /// Sets parameters and kernels in the uniform form. The program must be in use.
    void set_parameters(const PassBuild& build) const;

  private:
    ShaderProgram program_;
    std::vector<std::string> samplers_;
};

}  // namespace aoscore
