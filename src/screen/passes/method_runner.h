#pragma once

#include "core/image.h"
#include "screen/gbuffer/gbuffer.h"
#include "screen/gbuffer/input_textures.h"
#include "screen/passes/pass_program.h"
#include "screen/screen.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// Draws the passes of methods, filters and lighting over one G-buffer; keeps their programs and target
/// textures.
class MethodRunner {
  public:
    explicit MethodRunner(const GBuffer& gbuffer);

    struct Step {
        const Pass* pass = nullptr;
        PassBuild build;
        const PassProgram* program = nullptr;  ///< null where the processor computes the pass
    };
    /// A request whose programs are compiled. The request must outlive it.
    struct Frame {
        std::vector<Step> method, filter, lighting;
        InputSettings settings;
    };
    /// Compiles programs that are missing. Throws usage_error where the method does not support the
    /// resolution.
    Frame prepare(const MethodRequest& request);

    /// Draws the depth layers that the AO passes read, as draw_method() would first. False where they read
    /// none.
    bool draw_depth_layers(const Frame& frame);
    /// Draws the AO passes in the request's resolution mode; the result is raw().
    void draw_method(const Frame& frame);
    /// Sets raw() to visibility of the picture's size that was made elsewhere.
    void take_raw(const ImageF& visibility);
    /// Draws the filter's passes over raw(); the result is filtered(), which is raw() without a filter.
    void draw_filter(const Frame& frame);
    /// Draws the lighting's pass, if there is one, over filtered(); the result is lit().
    void draw_lighting(const Frame& frame);
    /// Counts the taps a pixel of the AO passes, at the picture's resolution. Throws file_error for a method
    /// whose loops the rasteriser has cut short.
    ImageF count_fetches(const MethodRequest& request);

    ImageF raw() const { return read(raw_.name()); }
    ImageF filtered() const { return read(filtered_->name()); }
    /// Reads a signal beside visibility of the AO pass; draw_method() must have drawn it.
    SignalImage signal_image(const std::string& id) const;
    /// Reads the lit picture in linear RGB. draw_lighting() must have drawn it since the G-buffer was drawn.
    Image<glm::vec3> lit() const;

    /// Who gathers layers by rays; the function must live as long as this.
    void set_ray_layers(const RayLayerSource* source) { inputs_.set_ray_layers(source); }
    DepthLayerBuffer& depth_layers() { return inputs_.depth_layers(); }

    /// Depth layers of this G-buffer, to be kept with it while another is in use.
    InputTextures::Layers take_layers() { return inputs_.take_layers(); }
    void put_back(InputTextures::Layers layers) { inputs_.put_back(std::move(layers)); }

    std::uint64_t layered_pictures_drawn() const { return inputs_.layered_pictures_drawn(); }
    std::uint64_t passes_drawn() const { return passes_; }
    std::uint64_t programs_compiled() const { return compilations_; }

    /// Forgets inputs that were computed from the G-buffer, so that they are computed again.
    void forget_derived() { inputs_.forget_derived(); }

  private:
    /// Throws usage_error where the method does not support the resolution.
    void check_resolution(const MethodRequest& request) const;
    /// Throws usage_error where the method does not give the signals, or not at this resolution.
    static void check_signals(const MethodRequest& request);
    PassBuild base_build(const MethodRequest& request, const MethodDescriptor& descriptor,
                         const ParameterValues& parameters) const;
    std::vector<Step> method_steps(const MethodRequest& request) const;
    /// The steps of a filter or the lighting; none where `descriptor` is null.
    std::vector<Step> following_steps(const MethodRequest& request, const MethodDescriptor* descriptor,
                                      const ParameterValues& parameters) const;

    const PassProgram* program(const Step& step);
    static void try_users_shader(const PassBuild& build, const Pass& pass, const ShaderSource& source);
    /// Throws file_error where the rasteriser has cut a pixel's loops short.
    void settle_counts(const Step& step, const InputSettings& settings, ImageF& counted);
    void check_listed_inputs(const PassBuild& build, const Pass& pass, const PassProgram& made);

    void allocate();
    gl::Texture& scaled_target(std::size_t step, int scale);
    /// A texture that a pass draws into, with its value where nothing is drawn.
    struct Target {
        GLuint texture;
        std::array<float, 4> clear;
    };
    /// Draws a step. In the dual mode's fine pass the first target keeps its content.
    void draw(const Step& step, const std::vector<Target>& targets, const InputSettings& settings,
              GLuint previous);
    /// The targets of a step: `first`, and one for each of its signals.
    std::vector<Target> targets_of(const Step& step, GLuint first);
    void process(const Step& step, GLuint target, const InputSettings& settings);
    void upsample(GLuint coarse, int scale);
    /// Reads a one-channel texture of the picture's size.
    ImageF read(GLuint texture) const;
    void write(GLuint texture, const ImageF& image) const;

    const GBuffer* gbuffer_;
    InputTextures inputs_;
    gl::VertexArray empty_vertices_;  // a core context cannot draw without one
    std::map<std::string, PassProgram> programs_;
    std::map<std::string, ShaderProgram> upsampling_;
    std::set<std::string> checked_inputs_;
    int width_ = 0, height_ = 0;
    std::uint64_t passes_ = 0, compilations_ = 0;
    gl::Texture raw_, first_, second_, fetches_;
    gl::Texture lit_;  // made when a frame is first lit
    const gl::Texture* filtered_ = &raw_;
    std::map<std::pair<std::size_t, int>, gl::Texture> scaled_;
    std::map<std::string, gl::Texture> signals_;  // by id, made when first asked for
};

}  // namespace aoscore
