#include "hand_made.h"
#include "support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace aoscore::testing {
namespace {

// The view depth at which a pixel's ray meets the plane n.x = n.c.
double plane_depth(const CameraFrame& frame, int x, int y, const glm::dvec3& centre,
                   const glm::dvec3& normal) {
    const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
    return glm::dot(normal, centre - ray.origin) / glm::dot(normal, ray.direction);
}

struct PlaneErrors {
    double depth = 0;   // largest, relative to the pixel's footprint
    double normal = 0;  // largest angle, rad
    std::size_t surface = 0;
};

PlaneErrors plane_errors(const Camera& camera, const glm::dvec3& centre, const glm::dvec3& normal,
                         const glm::dmat4& scene_from_mesh = glm::dmat4(1.0)) {
    Scene scene = plane_scene(glm::dvec3(glm::inverse(scene_from_mesh) * glm::dvec4(centre, 1)), normal, 400);
    scene.instances[0].scene_from_mesh = scene_from_mesh;
    const CameraFrame frame(camera, 321, 187);
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(frame, {"normal_geometric", "normal_smooth"});
    const GBufferImages images = renderer.read_gbuffer();
    glm::dvec3 view_normal = glm::dmat3(frame.view_from_world()) * normal;
    PlaneErrors errors;
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            if (images.surface.at(x, y) == 0) continue;
            ++errors.surface;
            const double expected = plane_depth(frame, x, y, centre, normal);
            const double got = static_cast<double>(images.linear_depth().at(x, y));
            const glm::dvec3 facing =
                glm::dot(normal, frame.ray(x + 0.5, y + 0.5).direction) > 0 ? -view_normal : view_normal;
            errors.depth = std::max(errors.depth, std::abs(got - expected) / frame.pixel_footprint(expected));
            errors.normal = std::max(
                errors.normal, glm::length(glm::dvec3(images.vector("normal_geometric").at(x, y)) - facing));
            EXPECT_EQ(images.vector("normal_geometric").at(x, y), images.vector("normal_smooth").at(x, y));
            EXPECT_NEAR(static_cast<double>(images.number("hardware_depth").at(x, y)),
                        frame.window_depth(expected), 1e-5);
        }
    }
    return errors;
}

// The tolerance is a hundredth of a pixel's footprint: on these slopes, a rasteriser off by half a pixel
// would exceed it tens of times.
constexpr double kDepthTolerance = 0.01;
constexpr double kNormalTolerance = 1e-6;

TEST(GBuffer, TiltedPlaneLiesWhereTheCamerasRaysMeetIt) {
    for (const glm::dvec3& n :
         {glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.3, 1), glm::dvec3(-1, 1, 0.8), glm::dvec3(0, 3, 1)}) {
        const PlaneErrors errors = plane_errors(front_camera(), {0, 0, -3}, glm::normalize(n));
        EXPECT_GT(errors.surface, 20000U);
        EXPECT_LT(errors.depth, kDepthTolerance) << n.x << " " << n.y;
        EXPECT_LT(errors.normal, kNormalTolerance);
    }
}

TEST(GBuffer, OrthographicPlaneLiesWhereTheCamerasRaysMeetIt) {
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = 1.3;
    for (const glm::dvec3& n : {glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.3, 1), glm::dvec3(-1, 1, 0.8)}) {
        const PlaneErrors errors = plane_errors(camera, {0, 0, -5}, glm::normalize(n));
        EXPECT_GT(errors.surface, 50000U);
        EXPECT_LT(errors.depth, kDepthTolerance);
        EXPECT_LT(errors.normal, kNormalTolerance);
    }
}

TEST(GBuffer, SceneFarFromItsOriginKeepsItsDetails) {
    const glm::dvec3 far_away(3e6, -2e6, 1e6);
    Camera camera = front_camera();
    camera.position += far_away;
    camera.target += far_away;
    const PlaneErrors errors =
        plane_errors(camera, glm::dvec3(0, 0, -3) + far_away, glm::normalize(glm::dvec3(0.5, 0.2, 1)),
                     glm::translate(glm::dmat4(1.0), far_away));
    EXPECT_GT(errors.surface, 20000U);
    EXPECT_LT(errors.depth, kDepthTolerance);
}

TEST(GBuffer, MirroredAndFlattenedInstancesFaceTheCamera) {
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
    const glm::dmat4 flattened = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -3)) *
                                 glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 0));
    Scene scene = plane_scene({0, 0, -3}, glm::normalize(glm::dvec3(0.5, 0, 1)), 50);
    for (const glm::dmat4& matrix : {mirrored, flattened}) {
        scene.instances[0].scene_from_mesh = matrix;
        ScreenRenderer renderer;
        renderer.set_scene(scene);
        renderer.draw_gbuffer(CameraFrame(front_camera(), 32, 32), {"normal_geometric"});
        const glm::vec3 n = renderer.read_gbuffer().vector("normal_geometric").at(16, 16);
        const glm::dvec3 expected =
            matrix == mirrored ? glm::normalize(glm::dvec3(-0.5, 0, 1)) : glm::dvec3(0, 0, 1);
        EXPECT_LT(glm::length(glm::dvec3(n) - expected), 1e-6);
    }
}

TEST(GBuffer, BackgroundHasTheFarPlanesDepthAndNoSurface) {
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    const CameraFrame frame(corner_camera(), 160, 90);
    renderer.draw_gbuffer(frame, {});
    const GBufferImages images = renderer.read_gbuffer();
    EXPECT_TRUE(images.vector("normal_geometric").empty());
    std::size_t background = 0;
    for (std::size_t i = 0; i < images.surface.size(); ++i) {
        if (images.surface.pixels[i] != 0) continue;
        ++background;
        EXPECT_EQ(images.linear_depth().pixels[i], 30.0F);
        EXPECT_EQ(images.number("hardware_depth").pixels[i], 1.0F);
    }
    EXPECT_GT(background, 100U);
    EXPECT_LT(background, images.surface.size() / 2);
}

// On a quad that fills the picture with a checker of alpha, holes must be those of alpha_at(), pixel for
// pixel, except where alpha lies within rounding of the cutoff.
TEST(GBuffer, CutOutsAreThoseOfAlphaAt) {
    for (const auto wrap :
         {Texture::Wrap::repeat, Texture::Wrap::mirrored_repeat, Texture::Wrap::clamp_to_edge}) {
        Scene scene = empty_scene();
        Texture texture;
        texture.texels = Image<glm::u8vec4>(5, 3);
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 5; ++x)
                texture.texels.at(x, y) = glm::u8vec4(255, 255, 255, (x * 7 + y * 5) % 4 * 85);
        }
        texture.wrap_s = wrap;
        texture.wrap_t = wrap;
        scene.textures.push_back(texture);
        scene.materials[0].texture = 0;
        scene.materials[0].base_color.a = 0.9F;
        scene.materials[0].alpha_cutoff = 0.45F;
        add_quad(scene, {-2, 2, -2}, {4, 0, 0}, {0, -4, 0});
        constexpr double kTiles = 3.3, kShift = -1.2;
        for (auto& uv : scene.meshes[0].texcoords)
            uv = uv * static_cast<float>(kTiles) + static_cast<float>(kShift);

        Camera camera = front_camera();
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = 2;
        constexpr int kSize = 300;
        ScreenRenderer renderer;
        renderer.set_scene(scene);
        renderer.draw_gbuffer(CameraFrame(camera, kSize, kSize), {});
        const Mask surface = renderer.read_gbuffer().surface;
        int cut = 0, wrong = 0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::vec2 uv((x + 0.5) / kSize * kTiles + kShift, (y + 0.5) / kSize * kTiles + kShift);
                const float alpha = alpha_at(scene, scene.materials[0], uv);
                if (std::abs(alpha - 0.45F) < 1e-4F) continue;
                cut += alpha < 0.45F ? 1 : 0;
                wrong += (alpha >= 0.45F) != (surface.at(x, y) != 0) ? 1 : 0;
            }
        }
        EXPECT_GT(cut, kSize * kSize / 10);
        EXPECT_EQ(wrong, 0) << "wrap mode " << static_cast<int>(wrap);
    }
}

}  // namespace
}  // namespace aoscore::testing
