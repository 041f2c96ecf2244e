#include "screen/gbuffer/depth_layer_buffer.h"

#include "core/error.h"
#include "core/known_names.h"
#include "screen/gl/texture.h"
#include "screen/passes/pass_program.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace aoscore {
namespace {

constexpr int kInTexel = 4;  ///< samples in a texel of four numbers

TextureFormat format_of(int samples) {
    if (samples == 1) return kR32F;
    return samples == 2 ? kRg32F : kRgba32F;
}

int textures_for(int samples) {
    return (samples + kInTexel - 1) / kInTexel;
}

std::string macros_of(const DepthLayers& layers, Mirror mirror) {
    const DepthSampling& sampling = row_of(depth_samplings(), layers.sampling, "no sampling of depth layers");
    return fmt::format("#define SAMPLES {}\n#define PER_SAMPLE {}\n#define {}\n{}{}", layers.samples,
                       layers.per_sample ? 1 : 0, sampling.macro,
                       layers.least_gap_m > 0 ? "#define LEAST_GAP\n" : "", mirror_macros(mirror));
}

bool same_shape(const DepthLayers& a, const DepthLayers& b) {
    return textures_for(a.samples) == textures_for(b.samples) &&
           format_of(a.samples).internal == format_of(b.samples).internal;
}

/// Empties every sample of the bound framebuffer.
void clear_samples(int textures, float far) {
    const std::array<float, 4> empty = {far, far, far, far};
    for (int i = 0; i < textures; ++i) gl::ClearBufferfv(GL_COLOR, i, empty.data());
}

}  // namespace

GLuint DepthLayerBuffer::texture(const GBuffer& gbuffer, const DepthLayers& layers, Mirror mirror) {
    if (!drawn_ || drawn_->is_stale || drawn_->layers != layers || drawn_->mirror != mirror)
        draw(gbuffer, layers, mirror, gbuffer.geometry().draws());
    return drawn_->array.name();
}

// Fresh memory costs a page fault for every 4 KB, which for sixteen samples is as much as drawing some
// layers: what fits is used again.
void DepthLayerBuffer::allocate(int width, int height, const DepthLayers& layers) {
    if (drawn_ && drawn_->width == width && drawn_->height == height && same_shape(drawn_->layers, layers)) {
        drawn_->is_stale = false;
        return;
    }
    drawn_.reset();  // frees its memory for the next one
    gl::Texture array =
        make_texture_array(format_of(layers.samples), width, height, textures_for(layers.samples));
    drawn_ = Drawn{.layers = layers, .width = width, .height = height, .array = std::move(array)};
}

void DepthLayerBuffer::draw(const GBuffer& gbuffer, const DepthLayers& layers, Mirror mirror,
                            std::span<const SceneGeometry::Draw> draws) {
    allocate(gbuffer.width(), gbuffer.height(), layers);
    drawn_->layers = layers;
    drawn_->mirror = mirror;
    const glm::mat4 scene_from_view(gbuffer.frame().world_from_view());
    SceneDrawing::Look look{&gbuffer.geometry(), draws, &gbuffer.frame(), macros_of(layers, mirror), 0, {}};
    look.set_uniforms = [&layers, scene_from_view](const ShaderProgram& p) {
        gl::Uniform1f(p.location("u_alpha"), static_cast<float>(layers.alpha));
        gl::Uniform1ui(p.location("u_seed"), layers.seed);
        gl::Uniform1f(p.location("u_least_gap"), static_cast<float>(layers.least_gap_m));
        gl::UniformMatrix4fv(p.location("u_scene_from_view"), 1, GL_FALSE, glm::value_ptr(scene_from_view));
    };
    if (layers.sampling == "peeled") {
        peel(gbuffer, std::move(look));
    } else {
        blend(gbuffer, std::move(look));
    }
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check("drawing depth layers");
}

// Draws all samples at once by blending with the minimum, which ignores the order of its operands.
void DepthLayerBuffer::blend(const GBuffer& gbuffer, SceneDrawing::Look look) {
    const int textures = textures_for(drawn_->layers.samples);
    const gl::Framebuffer framebuffer = make_array_framebuffer(drawn_->array.name(), 0, textures);
    clear_samples(textures, gbuffer.far_depth());
    gl::Enable(GL_BLEND);
    gl::BlendEquation(GL_MIN);
    drawing_.draw(look);
    gl::Disable(GL_BLEND);
}

// Draws each layer by a pass of its own, into one number of the texel.
void DepthLayerBuffer::peel(const GBuffer& gbuffer, SceneDrawing::Look look) {
    const int width = gbuffer.width(), height = gbuffer.height();
    const std::array<gl::Texture, 2> depths = {make_texture(kDepth32F, width, height),
                                               make_texture(kDepth32F, width, height)};
    const float farthest = 1.0F;
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    for (int layer = 0; layer < drawn_->layers.samples; ++layer) {
        const gl::Texture& depth = depths[static_cast<std::size_t>(layer % 2)];
        const gl::Framebuffer framebuffer =
            make_array_framebuffer(drawn_->array.name(), layer / kInTexel, 1, depth.name());
        if (layer % kInTexel == 0) clear_samples(1, gbuffer.far_depth());
        gl::ClearBufferfv(GL_DEPTH, 0, &farthest);
        const auto writes = [at = layer % kInTexel](int i) -> GLboolean {
            return i == at ? GL_TRUE : GL_FALSE;
        };
        gl::ColorMask(writes(0), writes(1), writes(2), writes(3));
        drawing_.draw(look);
        gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        look.layer_before = depth.name();
    }
    gl::Disable(GL_DEPTH_TEST);
}

std::vector<ImageF> DepthLayerBuffer::read() const {
    if (!drawn_ || drawn_->is_stale) throw internal_error("no depth layers were drawn", "DepthLayerBuffer");
    const int samples = drawn_->layers.samples, textures = textures_for(samples);
    const TextureFormat format = format_of(samples);
    const std::size_t in_texel = samples == 1 ? 1 : samples == 2 ? 2 : kInTexel;
    const std::size_t pixels =
        static_cast<std::size_t>(drawn_->width) * static_cast<std::size_t>(drawn_->height);
    std::vector<float> all(pixels * in_texel * static_cast<std::size_t>(textures));
    read_texture_array(drawn_->array.name(), format.transfer, all.data());
    std::vector<ImageF> images(static_cast<std::size_t>(samples), ImageF(drawn_->width, drawn_->height));
    for (std::size_t sample = 0; sample < images.size(); ++sample) {
        const std::size_t first = sample / in_texel * pixels * in_texel + sample % in_texel;
        for (std::size_t i = 0; i < pixels; ++i) images[sample].pixels[i] = all[first + i * in_texel];
    }
    return images;
}

}  // namespace aoscore
