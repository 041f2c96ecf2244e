#include "screen/gbuffer/peeled_surfaces.h"

#include "image/surface_channels.h"
#include "screen/gbuffer/scene_drawing.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/texture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

SurfaceLayer layer_of(const std::vector<glm::vec4>& texels, int width, int height) {
    SurfaceLayer layer{ImageF(width, height), ImageF(width, height), ImageF(width, height)};
    for (std::size_t i = 0; i < texels.size(); ++i) {
        layer.depth_m.pixels[i] = texels[i].x;
        layer.triangle_low.pixels[i] = texels[i].y;
        layer.triangle_high.pixels[i] = texels[i].z;
    }
    return layer;
}

}  // namespace

std::vector<SurfaceLayer> peel_surfaces(const SceneGeometry& geometry, const CameraFrame& frame) {
    const ViewUniforms view(frame);
    const gl::Texture surface = make_texture(kRgba32F, view.width, view.height);
    const std::array<gl::Texture, 2> depths = {make_texture(kDepth32F, view.width, view.height),
                                               make_texture(kDepth32F, view.width, view.height)};
    const std::array<float, 4> empty = {static_cast<float>(view.far), 0, 0, 0};
    const float farthest = 1.0F;
    SceneDrawing drawing("surfaces behind one another", "peeled_surfaces.frag");
    SceneDrawing::Look look{&geometry, geometry.draws(), &frame, "", 0, {}};
    std::vector<glm::vec4> texels(static_cast<std::size_t>(view.width) *
                                  static_cast<std::size_t>(view.height));
    std::vector<SurfaceLayer> layers;
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_LESS);
    while (layers.size() < SurfaceChannels::kMost) {
        const gl::Texture& depth = depths[layers.size() % 2];
        const gl::Framebuffer framebuffer = make_framebuffer({surface.name()});
        gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.name(), 0);
        gl::ClearBufferfv(GL_COLOR, 0, empty.data());
        gl::ClearBufferfv(GL_DEPTH, 0, &farthest);
        drawing.draw(look);
        read_texture(surface.name(), GL_RGBA, texels.data());
        if (std::ranges::all_of(texels, [&](const glm::vec4& texel) { return texel.x == empty[0]; })) break;
        layers.push_back(layer_of(texels, view.width, view.height));
        look.layer_before = depth.name();
    }
    gl::Disable(GL_DEPTH_TEST);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check("peeling surfaces");
    return layers;
}

}  // namespace aoscore
