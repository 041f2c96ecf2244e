#include "screen/gbuffer/depth_layer_buffer.h"

#include "core/error.h"
#include "core/known_names.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/texture.h"
#include "screen/passes/pass_program.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {
namespace {

constexpr int kInTexel = 4;  ///< samples in a texel of four numbers

TextureFormat format_of(int samples) {
    if (samples == 1) return kR32F;
    return samples == 2 ? kRg32F : kRgba32F;
}

std::size_t numbers_in_texel(int samples) {
    return static_cast<std::size_t>(samples <= 2 ? samples : kInTexel);
}

int textures_for(int samples) {
    return (samples + kInTexel - 1) / kInTexel;
}

std::string macros_of(const DepthLayers& layers, Mirror mirror) {
    const DepthSampling& sampling = row_of(depth_samplings(), layers.sampling, "no sampling of depth layers");
    return fmt::format("#define SAMPLES {}\n#define PER_SAMPLE {}\n#define {}\n{}{}", layers.samples,
                       layers.per_sample ? 1 : 0, sampling.macro,
                       layers.least_gap_m > 0 ? "#define LEAST_GAP\n" : "",
                       (layers.facing ? "#define FACING\n" : "") + mirror_macros(mirror));
}

bool same_shape(const LayeredPictures& a, const LayeredPictures& b) {
    const CameraFrame &of_a = a.cameras.front(), &of_b = b.cameras.front();
    return textures_for(a.layers.samples) == textures_for(b.layers.samples) &&
           format_of(a.layers.samples).internal == format_of(b.layers.samples).internal &&
           a.cameras.size() == b.cameras.size() && of_a.width() == of_b.width() &&
           of_a.height() == of_b.height();
}

bool same_picture(const CameraFrame& a, const CameraFrame& b) {
    return a.camera() == b.camera() && a.width() == b.width() && a.height() == b.height();
}

/// Empties every sample of the bound framebuffer.
void clear_samples(int textures, double far_m) {
    const auto far = static_cast<float>(far_m);
    const std::array<float, 4> empty = {far, far, far, far};
    for (int i = 0; i < textures; ++i) gl::ClearBufferfv(GL_COLOR, i, empty.data());
}

}  // namespace

bool LayeredPictures::operator==(const LayeredPictures& other) const {
    return layers == other.layers && mirror == other.mirror &&
           std::ranges::equal(cameras, other.cameras, same_picture);
}

GLuint DepthLayerBuffer::texture(const SceneGeometry& geometry, const LayeredPictures& wanted) {
    if (is_stale_ || drawn_ != wanted) draw(geometry, wanted, geometry.draws());
    return array_.name();
}

// Fresh memory costs a page fault for every 4 KB, which for sixteen samples is as much as drawing some
// layers: what fits is used again.
void DepthLayerBuffer::allocate(const LayeredPictures& wanted) {
    if (!drawn_ || !same_shape(*drawn_, wanted)) {
        const CameraFrame& camera = wanted.cameras.front();
        const int count = textures_for(wanted.layers.samples) * static_cast<int>(wanted.cameras.size());
        array_ = gl::Texture();  // frees its memory for the next one
        array_ = make_texture_array(format_of(wanted.layers.samples), camera.width(), camera.height(), count);
    }
    drawn_ = wanted;
    is_stale_ = false;
}

DepthLayerBuffer::Drawing DepthLayerBuffer::take() {
    if (is_stale_) return {};
    return {std::exchange(drawn_, std::nullopt), std::exchange(array_, gl::Texture())};
}

void DepthLayerBuffer::put_back(Drawing drawing) {
    drawn_ = std::move(drawing.pictures);
    array_ = std::move(drawing.array);
    is_stale_ = false;
}

void DepthLayerBuffer::draw(const SceneGeometry& geometry, const LayeredPictures& wanted,
                            std::span<const SceneGeometry::Draw> draws) {
    allocate(wanted);
    int first_texture = 0;
    for (const CameraFrame& camera : wanted.cameras) {
        draw_camera(geometry, camera, first_texture, draws);
        ++drawings_;
        first_texture += textures_for(wanted.layers.samples);
    }
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check("drawing depth layers");
}

void DepthLayerBuffer::draw_camera(const SceneGeometry& geometry, const CameraFrame& camera,
                                   int first_texture, std::span<const SceneGeometry::Draw> draws) {
    const DepthLayers& layers = drawn_->layers;
    if (!is_rasterised(layers.sampling)) return upload(met_by_rays(camera), first_texture);
    const glm::mat4 scene_from_view(camera.world_from_view());
    SceneDrawing::Look look{&geometry, draws, &camera, macros_of(layers, drawn_->mirror), 0, {}};
    look.set_uniforms = [&layers, scene_from_view](const ShaderProgram& p) {
        gl::Uniform1f(p.location("u_alpha"), static_cast<float>(layers.alpha));
        gl::Uniform1ui(p.location("u_seed"), layers.seed);
        gl::Uniform1f(p.location("u_least_gap"), static_cast<float>(layers.least_gap_m));
        gl::UniformMatrix4fv(p.location("u_scene_from_view"), 1, GL_FALSE, glm::value_ptr(scene_from_view));
    };
    if (layers.sampling == "peeled") {
        peel(std::move(look), first_texture);
    } else {
        blend(look, first_texture);
    }
}

// Draws all samples at once by blending with the minimum, which ignores the order of its operands.
// Nothing is tested against the samples that are there already. Between parts of the scene they could become
// a depth buffer, which would keep from being shaded what lies behind all of a texel's; but making it cost
// more than it saved: eight samples of the scene `layers` 1.18 times as many plain passes, in place of 0.77.
// Nor is left out what lies farther than R behind all that is seen around it, though no method with a radius
// would differ by a bit. As a depth buffer of those depths it keeps 41 % of the fragments of atrium/close and
// 46 % of Sponza's from being shaded, which costs what it saves (174 ms against 170, 295 against 304, at
// 1920x1080), since stores are masked; where little is out of reach it costs an eighth to a third more. Whole
// instances, or clusters of 128 triangles, out of reach hold 0 to 1 % of the fragments of five views, 8 % of
// atrium/close and at most 4 % of Sponza's.
void DepthLayerBuffer::blend(const SceneDrawing::Look& look, int first_texture) {
    const int textures = textures_for(drawn_->layers.samples);
    const gl::Framebuffer framebuffer = make_array_framebuffer(array_.name(), first_texture, textures);
    clear_samples(textures, ViewUniforms(*look.frame).far);
    gl::Enable(GL_BLEND);
    gl::BlendEquation(GL_MIN);
    drawing_.draw(look);
    gl::Disable(GL_BLEND);
}

// Draws each layer by a pass of its own, into one number of the texel.
void DepthLayerBuffer::peel(SceneDrawing::Look look, int first_texture) {
    const ViewUniforms view(*look.frame);
    const std::array<gl::Texture, 2> depths = {make_texture(kDepth32F, view.width, view.height),
                                               make_texture(kDepth32F, view.width, view.height)};
    const float farthest = 1.0F;
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    for (int layer = 0; layer < drawn_->layers.samples; ++layer) {
        const gl::Texture& depth = depths[static_cast<std::size_t>(layer % 2)];
        const gl::Framebuffer framebuffer =
            make_array_framebuffer(array_.name(), first_texture + layer / kInTexel, 1, depth.name());
        if (layer % kInTexel == 0) clear_samples(1, view.far);
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

std::vector<ImageF> DepthLayerBuffer::met_by_rays(const CameraFrame& camera) const {
    if (ray_layers_ == nullptr || !*ray_layers_) {
        throw usage_error("depth layers of the sampling rays need a ray tracer, which is not here",
                          "sampling", "another sampling; or score, run, sweep and claims");
    }
    return (*ray_layers_)(camera, drawn_->layers);
}

void DepthLayerBuffer::upload(const std::vector<ImageF>& samples, int first_texture) {
    const TextureFormat format = format_of(drawn_->layers.samples);
    const std::size_t in_texel = numbers_in_texel(drawn_->layers.samples), pixels = samples.front().size();
    std::vector<float> all(pixels * in_texel);
    gl::BindTexture(GL_TEXTURE_2D_ARRAY, array_.name());
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int texture = 0; texture < textures_for(drawn_->layers.samples); ++texture) {
        for (std::size_t k = 0; k < in_texel; ++k) {
            const std::size_t sample =
                std::min(static_cast<std::size_t>(texture) * in_texel + k, samples.size() - 1);
            for (std::size_t i = 0; i < pixels; ++i) all[i * in_texel + k] = samples[sample].pixels[i];
        }
        gl::TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, first_texture + texture, samples.front().width,
                          samples.front().height, 1, format.transfer, GL_FLOAT, all.data());
    }
}

std::vector<ImageF> DepthLayerBuffer::read() const {
    if (!drawn_ || is_stale_) throw internal_error("no depth layers were drawn", "DepthLayerBuffer");
    const int samples = drawn_->layers.samples, textures = textures_for(samples);
    const CameraFrame& camera = drawn_->cameras.front();
    const TextureFormat format = format_of(samples);
    const std::size_t in_texel = numbers_in_texel(samples);
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height());
    std::vector<float> all(pixels * in_texel * static_cast<std::size_t>(textures) * drawn_->cameras.size());
    read_texture_array(array_.name(), format.transfer, all.data());
    std::vector<ImageF> images;
    for (std::size_t at = 0; at < drawn_->cameras.size(); ++at) {
        for (std::size_t sample = 0; sample < static_cast<std::size_t>(samples); ++sample) {
            const std::size_t texture = at * static_cast<std::size_t>(textures) + sample / in_texel;
            const std::size_t first = texture * pixels * in_texel + sample % in_texel;
            ImageF& image = images.emplace_back(camera.width(), camera.height());
            for (std::size_t i = 0; i < pixels; ++i) image.pixels[i] = all[first + i * in_texel];
        }
    }
    return images;
}

}  // namespace aoscore
