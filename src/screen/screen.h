#pragma once

#include "core/image.h"
#include "core/signal.h"
#include "scene/scene.h"
#include "screen/gbuffer/capture.h"
#include "screen/method/depth_layers.h"
#include "screen/method/method.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// One picture of a G-buffer as the methods see it, read back. Row 0 at the top.
struct GBufferImages {
    Mask surface;  ///< 1 where something was drawn
    /// By channel (image/channels.h): those of one value, and those of three. Only what was drawn.
    std::map<std::string, ImageF, std::less<>> numbers;
    std::map<std::string, Image<glm::vec3>, std::less<>> vectors;

    /// Empty where that channel was not drawn.
    const ImageF& number(std::string_view channel) const;
    const Image<glm::vec3>& vector(std::string_view channel) const;
    /// View depth -z, metres; the far plane's where nothing was drawn.
    const ImageF& linear_depth() const { return number("linear_depth"); }
};

/// What a tap outside of the picture reads: the background's depth (nothing is known, nothing occludes), or
/// the depth of the nearest pixel.
enum class Border { far, clamp };

/// Where a method's normals come from: as its descriptor says, or in place of that the triangle's, the
/// interpolated ones, or the depth buffer's (simple differences; accurate: the better side of each pixel).
enum class Normals { as_described, geometric, smooth, from_depth, from_depth_accurate };

/// How exactly depth and normals are stored; normals from depth are made of what is stored. precision.h says
/// what each of them is. Window depth is OpenGL's, linear depth lies evenly between near and far plane; the
/// last one is an RGBA8 texture for both (Gravås, Image-space Ambient Obscurance in WebGL, 2013,
/// section 3.1).
enum class Precision { full, depth_32f, depth_32f_reversed, depth_24, depth_16, linear_16, packed_rgba8 };

/// How many pixels are shaded, for any method: all; a quarter of them, brought up by nearness in depth; the
/// same, and again in full where the coarse picture varies (Bavoil and Sainz, Multi-Layer Dual-Resolution
/// Screen-Space Ambient Occlusion, 2009); all, with taps that read a G-buffer of half the resolution (Filion
/// and McNaughton 2008).
enum class Resolution { full, half, dual, half_gbuffer };

/// Whether all that a method chooses at random (noise, kernels, frames, the pattern of depth mips) is
/// mirrored: for tests, where a mirrored scene must give the mirrored picture.
enum class Mirror { none, left_right, up_down };

/// What to run on the current G-buffer.
struct MethodRequest {
    const MethodDescriptor* method = nullptr;
    ParameterValues parameters;                ///< complete: MethodDescriptor::values()
    const MethodDescriptor* filter = nullptr;  ///< null: none
    ParameterValues filter_parameters;
    const MethodDescriptor* lighting = nullptr;  ///< load_lighting(); null: none
    ParameterValues lighting_parameters;
    std::uint64_t seed = 1;  ///< of kernels and noise
    Border border = Border::far;
    Normals normals = Normals::as_described;
    Resolution resolution = Resolution::full;
    Precision precision = Precision::full;
    /// Parameters and kernels as uniforms instead of constants: the same picture, slower; for comparison.
    bool uniform_form = false;
    Mirror mirror = Mirror::none;
    /// Signals beside visibility that the method is to give (see core/signal.h); none costs nothing.
    std::vector<std::string> signals;
};

/// What a method gives, by signal: visibility before and after its filter, and those that were asked for.
struct MethodOutput {
    ImageF raw;            ///< the AO pass, visibility; 1 on background
    ImageF visibility;     ///< after the filter (equals raw without one)
    Image<glm::vec3> lit;  ///< the lighting pass, linear RGB, black on background; empty without one
    std::map<std::string, SignalImage> signals;  ///< by id, beside visibility; unfiltered
};

/// The ids of the G-buffer's channels (image/channels.h).
const std::set<std::string>& gbuffer_inputs();
/// What a method's pass may ask for: the G-buffer's channels and what is made from them.
const std::set<std::string>& method_inputs();
/// What a filter's pass may ask for: a method's inputs and "visibility", the picture to be filtered.
const std::set<std::string>& filter_inputs();

/// The G-buffer inputs that a request reads: what draw_gbuffer() must be asked for before it runs.
std::set<std::string> needed_gbuffer_inputs(const MethodRequest& request);

/// OpenGL 3.3 on OSMesa: draws one G-buffer and runs screen-space methods on it. One instance at a time a
/// thread.
class ScreenRenderer {
  public:
    ScreenRenderer();
    ~ScreenRenderer();

    std::string renderer() const;  ///< GL_RENDERER
    std::string version() const;   ///< GL_VERSION

    /// Uploads geometry and cut-out textures.
    void set_scene(const Scene& scene);
    /// Draws the G-buffer: the capture's channels, and depth always. All requests after it use it. Returns
    /// milliseconds to glFinish.
    double draw_gbuffer(const Capture& capture);
    /// One frame, one layer, one eye.
    double draw_gbuffer(const CameraFrame& frame, const std::set<std::string>& channels) {
        return draw_gbuffer(Capture(frame, channels));
    }
    /// The G-buffer that was drawn last, drawn again for the clock. Milliseconds to glFinish.
    double time_gbuffer();
    /// One picture of what was drawn.
    GBufferImages read_gbuffer(const CaptureIndex& index = {});
    /// Draws the G-buffer's scene into depth layers, as methods that ask for them read them. Milliseconds to
    /// glFinish.
    double draw_depth_layers(const DepthLayers& layers);
    /// The depth layers that were drawn last: view depth in metres, a picture for each sample; the far
    /// plane's where a sample is empty.
    std::vector<ImageF> read_depth_layers();
    /// Digest of all G-buffer textures' bytes: equal before and after a method ran.
    std::string gbuffer_digest();

    /// Compiles what is needed (cached), runs once. Throws internal_error with the numbered source for a
    /// shader that does not compile, file_error where descriptor and shader disagree on inputs or parameters.
    MethodOutput run(const MethodRequest& request);

    /// The request's filter over a picture that was made elsewhere, visibility of the G-buffer's size; the
    /// picture itself without one.
    ImageF filter(const ImageF& visibility, const MethodRequest& request);

    /// What was done since the renderer was made.
    struct Work {
        std::uint64_t gbuffers = 0;      ///< drawn, those for the clock alone left out
        std::uint64_t passes = 0;        ///< drawn or computed, of methods, filters and lighting
        std::uint64_t compilations = 0;  ///< of their programs
    };
    Work work() const;

    struct PassTimes {
        double ao_ms = 0;
        std::optional<double> filter_ms;
        std::optional<double> lighting_ms;
    };
    /// Runs once for the clock (nothing is read back; glFinish before it stops).
    PassTimes time(const MethodRequest& request);

    /// Where a frame is waited for: after each of its passes, as pass times are taken, or at its end alone.
    enum class Waits { after_every_pass, at_the_end };
    /// A whole frame for the clock: the G-buffer that was drawn last, then the request's passes.
    /// Milliseconds.
    double time_frame(const MethodRequest& request, Waits waits);

    /// Texture fetches a pixel of the AO passes, counted by an instrumented build of the same shader; 0 on
    /// background. Row 0 at the top.
    ImageF count_fetches(const MethodRequest& request);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aoscore
