#include "screen/screen.h"

#include "core/error.h"
#include "core/machine.h"
#include "core/processor_watch.h"
#include "screen/gbuffer/derived_inputs.h"
#include "screen/gbuffer/gbuffer.h"
#include "screen/gbuffer/peeled_surfaces.h"
#include "screen/gbuffer/precision.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gl/context.h"
#include "screen/gl/pass_timer.h"
#include "screen/gl/texture.h"
#include "screen/passes/method_runner.h"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

std::string gl_text(GLenum name) {
    const GLubyte* text = gl::GetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

bool draws_on_processor() {
    return is_software_renderer(gl_text(GL_RENDERER));
}

class Clock {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }
    /// Once all that was drawn has ended.
    ScreenRenderer::PassTime finished() const {
        gl::Finish();
        if (!draws_on_processor()) return {milliseconds(), std::nullopt};
        return {milliseconds(), on_processor_.milliseconds()};
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    ProcessorWatch on_processor_;
};

// Clips at 1: a pass may write more where only the mean over its filter's pixels counts. NaN stays NaN.
void cut_off_above_one(ImageF& image) {
    for (float& v : image.pixels) v = v > 1 ? 1 : v;
}

}  // namespace

struct ScreenRenderer::Impl {
    /// A G-buffer, and the passes over it.
    struct Stage {
        GBuffer gbuffer;
        MethodRunner runner{gbuffer};
        glm::ivec2 band_px{0};  ///< the guard band

        void draw_gbuffer_again() { gbuffer.draw(gbuffer.geometry(), Capture(gbuffer.capture())); }
        PassTime timed_gbuffer() {
            const Clock clock;
            draw_gbuffer_again();
            return clock.finished();
        }
        template <class Pixel>
        Image<Pixel> inner(const Image<Pixel>& drawn) const {
            return without_band(drawn, band_px);
        }
    };
    std::unique_ptr<GlContext> context = new_gl_context();
    std::shared_ptr<SceneGeometry> geometry;
    Stage stage;
    /// With a guard band, for the requests that ask for one; of width 0 where the G-buffer has changed since.
    std::optional<Stage> wide;
    RayLayerSource ray_layers;
    bool shows_scene = false;  ///< whether the current G-buffer is of the current scene
    std::uint64_t gbuffers_drawn = 0;
    /// A G-buffer with the geometry that it shows, which depth layers are drawn of, and the layers
    /// themselves.
    struct Kept {
        GBuffer gbuffer;
        std::shared_ptr<SceneGeometry> geometry;
        InputTextures::Layers layers;
    };
    std::vector<Kept> kept;                ///< the current one's place is empty
    std::optional<std::size_t> place;      ///< of the current G-buffer among the kept ones
    std::shared_ptr<SceneGeometry> shown;  ///< the geometry of the current G-buffer; null for pictures

    /// Leaves the current G-buffer, which stays where it is kept.
    void leave_gbuffer() {
        if (place)
            kept[*place] = {std::exchange(stage.gbuffer, GBuffer()), shown, stage.runner.take_layers()};
        place.reset();
        stage.runner.forget_derived();
        if (wide) wide->band_px = {0, 0};
    }

    Stage& ready_stage() {
        context->make_current();
        if (!stage.gbuffer.drawn()) throw internal_error("no G-buffer was drawn", "ScreenRenderer");
        return stage;
    }

    // Draws the picture with the request's guard band, where it is not the one that was drawn last.
    Stage& ready_stage(const MethodRequest& request) {
        const GBuffer& gbuffer = ready_stage().gbuffer;
        const glm::ivec2 band_px = request.guard_band.pixels(gbuffer.width(), gbuffer.height());
        if (band_px == glm::ivec2(0)) return stage;
        if (!shown)
            throw internal_error("a guard band needs the scene that the G-buffer shows", "ScreenRenderer");
        if (!wide) wide.emplace().runner.set_ray_layers(&ray_layers);
        if (wide->band_px != band_px) {
            wide->runner.forget_derived();
            wide->gbuffer.draw(*shown, widened(gbuffer.capture(), band_px));
            wide->band_px = band_px;
            ++gbuffers_drawn;
        }
        return *wide;
    }
};

ScreenRenderer::ScreenRenderer() : impl_(std::make_unique<Impl>()) {}

ScreenRenderer::~ScreenRenderer() {
    // Objects are deleted in their own context.
    impl_->context->make_current();
}

bool ScreenRenderer::lost() const {
    return gl::context_lost();
}

std::optional<Capture> ScreenRenderer::renew() {
    const GBuffer& gbuffer = impl_->stage.gbuffer;
    std::optional<Capture> drawn;
    if (impl_->shows_scene && gbuffer.drawn()) drawn = gbuffer.capture();
    RayLayerSource rays = std::move(impl_->ray_layers);
    impl_.reset();
    impl_ = std::make_unique<Impl>();
    if (rays) set_ray_layers(std::move(rays));
    return drawn;
}

std::string ScreenRenderer::renderer() const {
    impl_->context->make_current();
    return gl_text(GL_RENDERER);
}

std::string ScreenRenderer::version() const {
    impl_->context->make_current();
    return gl_text(GL_VERSION);
}

void ScreenRenderer::set_scene(const Scene& scene) {
    impl_->context->make_current();
    impl_->geometry = std::make_shared<SceneGeometry>(scene);
    impl_->shows_scene = false;
}

void ScreenRenderer::set_ray_layers(RayLayerSource source) {
    impl_->ray_layers = std::move(source);
    impl_->stage.runner.set_ray_layers(&impl_->ray_layers);
    impl_->stage.runner.forget_derived();
    if (impl_->wide) impl_->wide->runner.forget_derived();
}

double ScreenRenderer::draw_gbuffer(const Capture& capture) {
    impl_->context->make_current();
    if (!impl_->geometry) throw internal_error("no scene was set", "ScreenRenderer");
    impl_->leave_gbuffer();
    ++impl_->gbuffers_drawn;
    const Clock clock;
    impl_->stage.gbuffer.draw(*impl_->geometry, capture);
    impl_->shown = impl_->geometry;
    impl_->shows_scene = true;
    gl::Finish();
    return clock.milliseconds();
}

void ScreenRenderer::take_gbuffer(const CameraFrame& frame, const GBufferImages& images,
                                  const std::set<std::string>& channels) {
    impl_->context->make_current();
    impl_->leave_gbuffer();
    impl_->stage.gbuffer.take(images, Capture(frame, channels));
    impl_->shown.reset();
    impl_->shows_scene = false;
}

Image<glm::vec3> ScreenRenderer::read_normals_from_depth() {
    const GBuffer& gbuffer = impl_->ready_stage().gbuffer;
    DerivedInputs derived;
    Image<glm::vec3> normals(gbuffer.width(), gbuffer.height());
    read_texture(derived.normal_from_depth(gbuffer, gbuffer.texture("linear_depth"), true), GL_RGB,
                 normals.pixels.data());
    return normals;
}

std::size_t ScreenRenderer::keep_gbuffer() {
    impl_->ready_stage();
    if (!impl_->place) {
        impl_->place = impl_->kept.size();
        impl_->kept.emplace_back();
    }
    return *impl_->place;
}

void ScreenRenderer::use_gbuffer(std::size_t kept) {
    impl_->context->make_current();
    if (kept >= impl_->kept.size()) throw internal_error("no G-buffer was kept so", std::to_string(kept));
    if (impl_->place == kept) return;
    impl_->leave_gbuffer();
    Impl::Kept& again = impl_->kept[kept];
    impl_->stage.gbuffer = std::move(again.gbuffer);
    impl_->shown = std::move(again.geometry);
    impl_->stage.runner.put_back(std::move(again.layers));
    impl_->place = kept;
    impl_->shows_scene = false;
}

ScreenRenderer::PassTime ScreenRenderer::time_gbuffer() {
    return impl_->ready_stage().timed_gbuffer();
}

GBufferImages ScreenRenderer::read_gbuffer(const CaptureIndex& index) {
    return impl_->ready_stage().gbuffer.read(index);
}

double ScreenRenderer::draw_depth_layers(const DepthLayers& layers) {
    Impl::Stage& stage = impl_->ready_stage();
    DepthLayerBuffer& buffer = stage.runner.depth_layers();
    buffer.forget();
    const Clock clock;
    buffer.texture(stage.gbuffer.geometry(), {layers, {stage.gbuffer.frame()}});
    gl::Finish();
    return clock.milliseconds();
}

std::vector<ImageF> ScreenRenderer::read_depth_layers() {
    return impl_->ready_stage().runner.depth_layers().read();
}

std::vector<SurfaceLayer> ScreenRenderer::read_surfaces() {
    const GBuffer& gbuffer = impl_->ready_stage().gbuffer;
    return peel_surfaces(gbuffer.geometry(), gbuffer.frame());
}

std::string ScreenRenderer::gbuffer_digest() {
    return impl_->ready_stage().gbuffer.digest();
}

MethodOutput ScreenRenderer::run(const MethodRequest& request) {
    Impl::Stage& stage = impl_->ready_stage(request);
    MethodRunner& runner = stage.runner;
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.draw_method(frame);
    MethodOutput output;
    output.raw = stage.inner(runner.raw());
    if (request.filter == nullptr) {
        output.visibility = output.raw;
    } else {
        runner.draw_filter(frame);
        output.visibility = stage.inner(runner.filtered());
    }
    cut_off_above_one(output.raw);
    cut_off_above_one(output.visibility);
    for (const std::string& id : request.signals) {
        for (const ImageF& plane : runner.signal_image(id)) output.signals[id].push_back(stage.inner(plane));
    }
    if (request.lighting != nullptr) {
        runner.draw_lighting(frame);
        output.lit = stage.inner(runner.lit());
    }
    return output;
}

ImageF ScreenRenderer::filter(const ImageF& visibility, const MethodRequest& request) {
    MethodRunner& runner = impl_->ready_stage().runner;
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.take_raw(visibility);
    runner.draw_filter(frame);
    ImageF filtered = runner.filtered();
    cut_off_above_one(filtered);
    return filtered;
}

ScreenRenderer::PassTimes ScreenRenderer::time(const MethodRequest& request) {
    Impl::Stage& stage = impl_->ready_stage(request);
    MethodRunner& runner = stage.runner;
    const MethodRunner::Frame frame = runner.prepare(request);  // compiling is not part of a frame
    runner.forget_derived();  // a method's cost includes the inputs made for it
    gl::Finish();
    PassTimes times;
    if (stage.band_px != glm::ivec2(0)) times.gbuffer = stage.timed_gbuffer();
    const PassTimer::Clock clock = draws_on_processor() ? PassTimer::Clock::wall : PassTimer::Clock::queries;
    PassTimer ao(clock), filter(clock), lighting(clock);
    ao.begin();
    if (runner.draw_depth_layers(frame)) times.layers_processor_ms = ao.processor_ms_so_far();
    runner.draw_method(frame);
    ao.end();
    if (request.filter != nullptr) {
        filter.begin();
        runner.draw_filter(frame);
        filter.end();
    }
    if (request.lighting != nullptr) {
        lighting.begin();
        runner.draw_lighting(frame);
        lighting.end();
    }
    const auto time_of = [](const PassTimer& timer) {
        return PassTime{timer.milliseconds(), timer.processor_ms()};
    };
    times.ao = time_of(ao);
    if (request.filter != nullptr) times.filter = time_of(filter);
    if (request.lighting != nullptr) times.lighting = time_of(lighting);
    return times;
}

ScreenRenderer::PassTime ScreenRenderer::time_frame(const MethodRequest& request, Waits waits) {
    Impl::Stage& stage = impl_->ready_stage(request);
    MethodRunner& runner = stage.runner;
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.forget_derived();
    gl::Finish();
    const auto pass_drawn = [waits] {
        if (waits == Waits::after_every_pass) gl::Finish();
    };
    const Clock clock;
    stage.draw_gbuffer_again();
    pass_drawn();
    runner.draw_method(frame);
    pass_drawn();
    runner.draw_filter(frame);
    pass_drawn();
    runner.draw_lighting(frame);
    return clock.finished();
}

std::size_t ScreenRenderer::gbuffer_bytes(const MethodRequest& request) {
    const GBuffer& gbuffer = impl_->ready_stage(request).gbuffer;
    const bool positions = format_of(request.precision).positions;
    // Four floats in place of one.
    const std::size_t more = positions ? 3 * sizeof(float) : 0;
    return gbuffer.bytes() +
           more * static_cast<std::size_t>(gbuffer.width()) * static_cast<std::size_t>(gbuffer.height());
}

ScreenRenderer::Work ScreenRenderer::work() const {
    Work work{.gbuffers = impl_->gbuffers_drawn};
    for (const Impl::Stage* stage : {&impl_->stage, impl_->wide ? &*impl_->wide : nullptr}) {
        if (stage == nullptr) continue;
        work.layered_pictures += stage->runner.layered_pictures_drawn();
        work.passes += stage->runner.passes_drawn();
        work.compilations += stage->runner.programs_compiled();
    }
    return work;
}

ImageF ScreenRenderer::count_fetches(const MethodRequest& request) {
    Impl::Stage& stage = impl_->ready_stage(request);
    return stage.inner(stage.runner.count_fetches(request));
}

}  // namespace aoscore
