#pragma once

#include "core/image.h"
#include "core/signal.h"
#include "scene/scene.h"
#include "screen/gbuffer/capture.h"
#include "screen/gbuffer/guard_band.h"
#include "screen/gbuffer/surface_layer.h"
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

/// One picture of a G-buffer as methods see it, read back, with row 0 at the top.
struct GBufferImages {
    Mask surface;  ///< 1 where a surface was drawn
    /// The drawn channels (image/channels.h) of one value, and those of three, by id.
    std::map<std::string, ImageF, std::less<>> numbers;
    std::map<std::string, Image<glm::vec3>, std::less<>> vectors;

    /// The channel; empty where it was not drawn.
    const ImageF& number(std::string_view channel) const;
    const Image<glm::vec3>& vector(std::string_view channel) const;
    /// View depth -z, metres; the far plane's where nothing was drawn.
    const ImageF& linear_depth() const { return number("linear_depth"); }
};

/// The depth that a tap outside of the picture reads: the background's (the unknown does not occlude), or
/// that of the nearest pixel.
enum class Border { far, clamp };

/// The source of a method's normals: as its descriptor says, or instead the triangle's, the interpolated
/// ones, or the depth buffer's (by simple differences; accurate: by the better side of each pixel).
enum class Normals { as_described, geometric, smooth, from_depth, from_depth_accurate };

/// The precision of stored depth and normals; normals from depth use the stored depth. precision.h describes
/// each. Window depth is OpenGL's, linear depth is even between near and far plane; packed_rgba8 is one
/// texture for both (Gravås, Image-space Ambient Obscurance in WebGL, 2013, section 3.1), normal_xy leaves
/// out a normal's sign (section 3.1.5.1).
enum class Precision {
    full,
    depth_32f,
    depth_32f_reversed,
    depth_24,
    depth_16,
    linear_16,
    linear_16_300m,
    packed_rgba8,
    normal_xy,
    positions
};

/// The resolution of shading, for any method: all pixels; a quarter of them, upsampled by nearness in depth;
/// the same, with full shading where the coarse picture varies (Bavoil and Sainz, Multi-Layer Dual-Resolution
/// Screen-Space Ambient Occlusion, 2009); or all pixels, with taps that read a G-buffer of half the
/// resolution (Filion and McNaughton 2008).
enum class Resolution { full, half, dual, half_gbuffer };

/// Whether a method's randomness (noise, kernels, frames, the pattern of depth mips) is mirrored, for tests
/// in which a mirrored scene must give the mirrored picture.
enum class Mirror { none, left_right, up_down };

/// A request to run a method on the current G-buffer.
struct MethodRequest {
    const MethodDescriptor* method = nullptr;
    ParameterValues parameters;                ///< complete: MethodDescriptor::values()
    const MethodDescriptor* filter = nullptr;  ///< null: none
    ParameterValues filter_parameters;
    const MethodDescriptor* lighting = nullptr;  ///< load_lighting(); null: none
    ParameterValues lighting_parameters;
    std::uint64_t seed = 1;  ///< seed of kernels and noise
    Border border = Border::far;
    Normals normals = Normals::as_described;
    Resolution resolution = Resolution::full;
    Precision precision = Precision::full;
    GuardBand guard_band;  ///< every pass is drawn over the picture with it, filter and lighting too
    /// Makes parameters and kernels uniforms instead of constants, which gives the same picture more slowly.
    bool uniform_form = false;
    Mirror mirror = Mirror::none;
    /// Signals beside visibility that the method is to give (see core/signal.h).
    std::vector<std::string> signals;
};

/// A method's output: visibility before and after its filter, and further signals that were asked for.
struct MethodOutput {
    ImageF raw;            ///< the AO pass, visibility; 1 on background
    ImageF visibility;     ///< after the filter (equals raw without one)
    Image<glm::vec3> lit;  ///< the lighting pass, linear RGB, black on background; empty without one
    std::map<std::string, SignalImage> signals;  ///< signals beside visibility by id; unfiltered
};

/// The ids of the G-buffer's channels (image/channels.h).
const std::set<std::string>& gbuffer_inputs();
/// The inputs that a method's pass may list: the G-buffer's channels and inputs made from them.
const std::set<std::string>& method_inputs();
/// The inputs that a filter's pass may list: a method's inputs and "visibility", the picture to filter.
const std::set<std::string>& filter_inputs();

/// The G-buffer inputs that a request reads, which draw_gbuffer() must draw before it runs.
std::set<std::string> needed_gbuffer_inputs(const MethodRequest& request);

/// Gathers depth layers by rays: a picture of view depth in metres for each sample, the far plane's where it
/// is empty, row 0 at the top.
using RayLayerSource =
    std::function<std::vector<ImageF>(const CameraFrame& frame, const DepthLayers& layers)>;

/// OpenGL 3.3 on OSMesa: draws one G-buffer and runs screen-space methods on it. A thread may have one
/// instance at a time.
class ScreenRenderer {
  public:
    ScreenRenderer();
    ~ScreenRenderer();

    /// Whether the driver has lost the context, so that every call throws until renew().
    bool lost() const;
    /// Makes a new context in place of a lost one, without scene and G-buffers. Returns the capture of the
    /// G-buffer that was drawn last; nothing where none was, or it was not of the scene.
    std::optional<Capture> renew();

    std::string renderer() const;  ///< GL_RENDERER
    std::string version() const;   ///< GL_VERSION

    /// Uploads geometry and cut-out textures.
    void set_scene(const Scene& scene);
    /// Sets who gathers the depth layers of the sampling "rays", of the scene that is set. Without one,
    /// requests for them throw usage_error.
    void set_ray_layers(RayLayerSource source);
    /// Draws the G-buffer: the capture's channels, and depth always. All requests after it use it. Returns
    /// milliseconds to glFinish.
    double draw_gbuffer(const Capture& capture);
    /// Draws one frame, one layer and one eye.
    double draw_gbuffer(const CameraFrame& frame, const std::set<std::string>& channels) {
        return draw_gbuffer(Capture(frame, channels));
    }
    /// Takes pictures of this frame that were drawn elsewhere as the G-buffer: linear depth, with the far
    /// plane's on background, window depth, and of `channels` those that they have. Methods run on it that
    /// read one layer of depth, without a guard band.
    void take_gbuffer(const CameraFrame& frame, const GBufferImages& images,
                      const std::set<std::string>& channels);
    /// Computes view-space normals from the G-buffer's depth, as the input "normal_from_depth_accurate" has
    /// them; row 0 at the top.
    Image<glm::vec3> read_normals_from_depth();
    /// Keeps the current G-buffer, with the depth layers drawn of it, beside those that are drawn after it;
    /// returns a number for use_gbuffer(). It serves requests also after set_scene(); only layers by rays are
    /// then of the scene that is set. With a guard band the scene is drawn again.
    std::size_t keep_gbuffer();
    /// Makes a G-buffer that was kept the current one again, without drawing it. Throws internal_error for
    /// another number.
    void use_gbuffer(std::size_t kept);
    /// The time of one run.
    struct PassTime {
        double ms = 0;                       ///< by PassTimer's clock
        std::optional<double> processor_ms;  ///< of all threads of this process; empty on a GPU
    };
    /// Draws the last G-buffer again for the clock.
    PassTime time_gbuffer();
    /// Reads one picture of the G-buffer.
    GBufferImages read_gbuffer(const CaptureIndex& index = {});
    /// Draws the G-buffer's scene into depth layers, as methods read them. Returns milliseconds to glFinish.
    double draw_depth_layers(const DepthLayers& layers);
    /// Reads the depth layers that were drawn last: a picture of view depth in metres for each sample, the
    /// far plane's where it is empty.
    std::vector<ImageF> read_depth_layers();
    /// Peels off the surfaces of the G-buffer's scene that lie behind one another, front to back.
    std::vector<SurfaceLayer> read_surfaces();
    /// The digest of all G-buffer textures' bytes, which is equal before and after a method ran.
    std::string gbuffer_digest();

    /// Compiles programs that are missing, and runs the request once. Throws internal_error with the numbered
    /// source for a shader that does not compile, file_error where descriptor and shader disagree on inputs
    /// or parameters.
    MethodOutput run(const MethodRequest& request);

    /// Runs the request's filter over visibility of the G-buffer's size that was made elsewhere; returns that
    /// itself without a filter. A guard band has no part in it.
    ImageF filter(const ImageF& visibility, const MethodRequest& request);

    /// The work since the renderer was made.
    struct Work {
        std::uint64_t gbuffers = 0;          ///< G-buffers drawn, without those for the clock
        std::uint64_t layered_pictures = 0;  ///< depth layers drawn, those of one camera as one
        std::uint64_t passes = 0;            ///< passes of methods, filters and lighting
        std::uint64_t compilations = 0;      ///< programs compiled
    };
    Work work() const;

    struct PassTimes {
        PassTime ao;  ///< with the inputs that are made for the method alone, its depth layers among them
        /// The part of it that draws depth layers; empty for a method that reads none, and on a GPU.
        std::optional<double> layers_processor_ms;
        std::optional<PassTime> filter;
        std::optional<PassTime> lighting;
        std::optional<PassTime> gbuffer;  ///< of the picture with its guard band; empty without one
    };
    /// Runs once for the clock of PassTimer; nothing is read back.
    PassTimes time(const MethodRequest& request);

    /// The places to wait for a frame: after each of its passes, as for the times of passes, or only at its
    /// end.
    enum class Waits { after_every_pass, at_the_end };
    /// Times a whole frame: draws the last G-buffer again, then the request's passes.
    PassTime time_frame(const MethodRequest& request, Waits waits);

    /// The bytes of the G-buffer that the request reads, with its guard band.
    std::size_t gbuffer_bytes(const MethodRequest& request);

    /// Counts the texture fetches a pixel of the AO passes by an instrumented build of the same shader; 0 on
    /// background, row 0 at the top.
    ImageF count_fetches(const MethodRequest& request);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace aoscore
