#include "screen/screen.h"

#include "core/error.h"
#include "core/processor_watch.h"
#include "screen/gbuffer/gbuffer.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gl/context.h"
#include "screen/passes/method_runner.h"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

class Clock {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string gl_text(GLenum name) {
    const GLubyte* text = gl::GetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

// Clips at 1: a pass may write more where only the mean over its filter's pixels counts. NaN stays NaN.
void cut_off_above_one(ImageF& image) {
    for (float& v : image.pixels) v = v > 1 ? 1 : v;
}

}  // namespace

struct ScreenRenderer::Impl {
    std::unique_ptr<GlContext> context = new_gl_context();
    std::optional<SceneGeometry> geometry;
    GBuffer gbuffer;
    std::optional<MethodRunner> runner;
    std::uint64_t gbuffers_drawn = 0;
    std::vector<GBuffer> kept;         ///< the current one's place is empty
    std::optional<std::size_t> place;  ///< of the current G-buffer among the kept ones

    Impl() { runner.emplace(gbuffer); }

    /// Leaves the current G-buffer, which stays where it is kept.
    void leave_gbuffer() {
        if (place) kept[*place] = std::exchange(gbuffer, GBuffer());
        place.reset();
        runner->forget_derived();
    }

    MethodRunner& ready_runner() {
        context->make_current();
        if (!gbuffer.drawn()) throw internal_error("no G-buffer was drawn", "ScreenRenderer");
        return *runner;
    }

    void draw_gbuffer_again() { gbuffer.draw(*geometry, Capture(gbuffer.capture())); }
};

ScreenRenderer::ScreenRenderer() : impl_(std::make_unique<Impl>()) {}

ScreenRenderer::~ScreenRenderer() {
    // Objects are deleted in their own context.
    impl_->context->make_current();
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
    impl_->geometry.emplace(scene);
}

double ScreenRenderer::draw_gbuffer(const Capture& capture) {
    impl_->context->make_current();
    if (!impl_->geometry) throw internal_error("no scene was set", "ScreenRenderer");
    impl_->leave_gbuffer();
    ++impl_->gbuffers_drawn;
    const Clock clock;
    impl_->gbuffer.draw(*impl_->geometry, capture);
    gl::Finish();
    return clock.milliseconds();
}

std::size_t ScreenRenderer::keep_gbuffer() {
    impl_->ready_runner();
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
    impl_->gbuffer = std::move(impl_->kept[kept]);
    impl_->place = kept;
}

double ScreenRenderer::time_gbuffer() {
    impl_->ready_runner();
    const Clock clock;
    impl_->draw_gbuffer_again();
    gl::Finish();
    return clock.milliseconds();
}

GBufferImages ScreenRenderer::read_gbuffer(const CaptureIndex& index) {
    impl_->ready_runner();
    return impl_->gbuffer.read(index);
}

double ScreenRenderer::draw_depth_layers(const DepthLayers& layers) {
    DepthLayerBuffer& buffer = impl_->ready_runner().depth_layers();
    buffer.forget();
    const Clock clock;
    buffer.texture(impl_->gbuffer, layers, Mirror::none);
    gl::Finish();
    return clock.milliseconds();
}

std::vector<ImageF> ScreenRenderer::read_depth_layers() {
    return impl_->ready_runner().depth_layers().read();
}

std::string ScreenRenderer::gbuffer_digest() {
    impl_->ready_runner();
    return impl_->gbuffer.digest();
}

MethodOutput ScreenRenderer::run(const MethodRequest& request) {
    MethodRunner& runner = impl_->ready_runner();
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.draw_method(frame);
    MethodOutput output;
    output.raw = runner.raw();
    if (request.filter == nullptr) {
        output.visibility = output.raw;
    } else {
        runner.draw_filter(frame);
        output.visibility = runner.filtered();
    }
    cut_off_above_one(output.raw);
    cut_off_above_one(output.visibility);
    for (const std::string& id : request.signals) output.signals[id] = runner.signal_image(id);
    if (request.lighting != nullptr) {
        runner.draw_lighting(frame);
        output.lit = runner.lit();
    }
    return output;
}

ImageF ScreenRenderer::filter(const ImageF& visibility, const MethodRequest& request) {
    MethodRunner& runner = impl_->ready_runner();
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.take_raw(visibility);
    runner.draw_filter(frame);
    ImageF filtered = runner.filtered();
    cut_off_above_one(filtered);
    return filtered;
}

ScreenRenderer::PassTimes ScreenRenderer::time(const MethodRequest& request) {
    MethodRunner& runner = impl_->ready_runner();
    const MethodRunner::Frame frame = runner.prepare(request);  // compiling is not part of a frame
    runner.forget_derived();  // a method's cost includes the inputs made for it
    gl::Finish();
    PassTimes times;
    const Clock ao;
    const ProcessorWatch on_processor;
    if (runner.draw_depth_layers(frame)) {
        gl::Finish();
        times.layers_processor_ms = on_processor.milliseconds();
    }
    runner.draw_method(frame);
    gl::Finish();
    times.ao_processor_ms = on_processor.milliseconds();
    times.ao_ms = ao.milliseconds();
    if (request.filter != nullptr) {
        const Clock filter;
        runner.draw_filter(frame);
        gl::Finish();
        times.filter_ms = filter.milliseconds();
    }
    if (request.lighting != nullptr) {
        const Clock lighting;
        runner.draw_lighting(frame);
        gl::Finish();
        times.lighting_ms = lighting.milliseconds();
    }
    return times;
}

double ScreenRenderer::time_frame(const MethodRequest& request, Waits waits) {
    MethodRunner& runner = impl_->ready_runner();
    const MethodRunner::Frame frame = runner.prepare(request);
    runner.forget_derived();
    gl::Finish();
    const auto pass_drawn = [waits] {
        if (waits == Waits::after_every_pass) gl::Finish();
    };
    const Clock clock;
    impl_->draw_gbuffer_again();
    pass_drawn();
    runner.draw_method(frame);
    pass_drawn();
    runner.draw_filter(frame);
    pass_drawn();
    runner.draw_lighting(frame);
    gl::Finish();
    return clock.milliseconds();
}

ScreenRenderer::Work ScreenRenderer::work() const {
    return {impl_->gbuffers_drawn, impl_->runner->passes_drawn(), impl_->runner->programs_compiled()};
}

ImageF ScreenRenderer::count_fetches(const MethodRequest& request) {
    return impl_->ready_runner().count_fetches(request);
}

}  // namespace aoscore
