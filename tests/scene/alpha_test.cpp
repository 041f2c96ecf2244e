#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using aoscore::Material;
using aoscore::Scene;
using aoscore::Texture;

/// Alpha 0, 100, 200, 40 along u in one row.
Scene row_scene(Texture::Wrap wrap) {
    Scene scene;
    Texture texture;
    texture.texels = aoscore::Image<glm::u8vec4>(4, 1);
    const std::uint8_t alphas[] = {0, 100, 200, 40};
    for (int x = 0; x < 4; ++x) texture.texels.at(x, 0) = {9, 9, 9, alphas[x]};
    texture.wrap_s = texture.wrap_t = wrap;
    scene.textures.push_back(texture);
    Material material;
    material.texture = 0;
    scene.materials.push_back(material);
    return scene;
}

float byte_alpha(const Scene& scene, float u, float v = 0.5f) {
    return aoscore::alpha_at(scene, scene.materials[0], {u, v}) * 255;
}

TEST(Alpha, IsTheTexelAtItsCentreAndTheMeanBetweenTwo) {
    for (const auto wrap :
         {Texture::Wrap::repeat, Texture::Wrap::mirrored_repeat, Texture::Wrap::clamp_to_edge}) {
        const Scene scene = row_scene(wrap);
        EXPECT_NEAR(byte_alpha(scene, 0.125f), 0, 1e-4);
        EXPECT_NEAR(byte_alpha(scene, 0.375f), 100, 1e-4);
        EXPECT_NEAR(byte_alpha(scene, 0.625f), 200, 1e-4);
        EXPECT_NEAR(byte_alpha(scene, 0.5f), 150, 1e-4);
        EXPECT_NEAR(byte_alpha(scene, 0.8125f), 80, 1e-4);  // three quarters from 200 to 40
    }
}

TEST(Alpha, WrapsAsItsSamplerSays) {
    const Scene repeat = row_scene(Texture::Wrap::repeat);
    EXPECT_NEAR(byte_alpha(repeat, 1.375f), 100, 1e-3);
    EXPECT_NEAR(byte_alpha(repeat, -0.125f), 40, 1e-3);
    EXPECT_NEAR(byte_alpha(repeat, 0.0f), 20, 1e-3);  // between the last texel and the first
    EXPECT_NEAR(byte_alpha(repeat, 1.0f), 20, 1e-3);

    const Scene mirrored = row_scene(Texture::Wrap::mirrored_repeat);
    EXPECT_NEAR(byte_alpha(mirrored, -0.375f), 100, 1e-3);
    EXPECT_NEAR(byte_alpha(mirrored, 1.125f), 40, 1e-3);
    EXPECT_NEAR(byte_alpha(mirrored, 1.375f), 200, 1e-3);
    EXPECT_NEAR(byte_alpha(mirrored, 2.375f), 100, 1e-3);
    EXPECT_NEAR(byte_alpha(mirrored, 1.0f), 40, 1e-3);

    const Scene clamped = row_scene(Texture::Wrap::clamp_to_edge);
    EXPECT_NEAR(byte_alpha(clamped, -3.0f), 0, 1e-3);
    EXPECT_NEAR(byte_alpha(clamped, 7.0f), 40, 1e-3);
}

TEST(Alpha, StaysInRangeForAnyCoordinate) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::vector<float> wild = {std::numeric_limits<float>::quiet_NaN(),
                                     kInfinity,
                                     -kInfinity,
                                     3e38f,
                                     -3e38f,
                                     1e20f,
                                     -1e-30f,
                                     -1e-9f,
                                     16777217.0f,
                                     std::nextafter(1.0f, 0.0f),
                                     std::nextafter(2.0f, 0.0f)};
    for (const auto wrap :
         {Texture::Wrap::repeat, Texture::Wrap::mirrored_repeat, Texture::Wrap::clamp_to_edge}) {
        const Scene scene = row_scene(wrap);
        for (const float u : wild) {
            for (const float v : wild) {
                const float alpha = byte_alpha(scene, u, v);
                EXPECT_TRUE(alpha >= 0 && alpha <= 200) << u << " " << v << " " << alpha;
            }
        }
        EXPECT_EQ(byte_alpha(scene, kInfinity), byte_alpha(scene, 0.0f));
        EXPECT_EQ(byte_alpha(scene, std::numeric_limits<float>::quiet_NaN()), byte_alpha(scene, 0.0f));
    }
}

TEST(Alpha, IsMultipliedByTheFactor) {
    Scene scene = row_scene(Texture::Wrap::repeat);
    scene.materials[0].base_color.a = 0.5f;
    EXPECT_NEAR(byte_alpha(scene, 0.375f), 50, 1e-4);
    scene.materials[0].texture = -1;
    EXPECT_EQ(aoscore::alpha_at(scene, scene.materials[0], {0.2f, 0.7f}), 0.5f);
}

TEST(Alpha, InterpolatesAlongBothAxes) {
    Scene scene;
    Texture texture;
    texture.texels = aoscore::Image<glm::u8vec4>(2, 2);
    texture.texels.at(0, 0).a = 0;
    texture.texels.at(1, 0).a = 80;
    texture.texels.at(0, 1).a = 160;
    texture.texels.at(1, 1).a = 240;
    scene.textures.push_back(texture);
    Material material;
    material.texture = 0;
    scene.materials.push_back(material);
    EXPECT_NEAR(byte_alpha(scene, 0.5f, 0.5f), 120, 1e-4);
    EXPECT_NEAR(byte_alpha(scene, 0.375f, 0.625f), 20 + 0.75f * 160, 1e-4);
    EXPECT_NEAR(byte_alpha(scene, 0.25f, 0.75f), 160, 1e-4);  // row 1 is at the larger v
}

}  // namespace
