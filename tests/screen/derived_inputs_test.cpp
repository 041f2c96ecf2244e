#include "core/files.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore::testing {
namespace {

// A method that shows an input, as the cosine between two normals.
MethodDescriptor normal_viewer(const std::string& source) {
    const auto folder = output_dir();
    write_atomically(folder / "viewer" / "method.json", R"({"label": "v", "paper": "none", "summary": "v",
        "passes": [{"fragment": "v.frag", "inputs": ["linear_depth", "normal_geometric", ")" +
                                                            source + R"("]}]})");
    write_atomically(folder / "viewer" / "v.frag", R"(#include "contract/ao_pass.glsl"
        float visibility(vec2 image_px, vec3 position) { return dot(centre_normal_geometric(), centre_)" +
                                                       source + "()); }");
    return find_method(load_methods(folder), "viewer");
}

double least_cosine(const Scene& scene, const Camera& camera, const std::string& source, double edge_share) {
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(CameraFrame(camera, 240, 135), gbuffer_inputs());
    const MethodDescriptor viewer = normal_viewer(source);
    std::vector<float> cosines = renderer.run(request_for(viewer, {}, "default")).raw.pixels;
    const auto at =
        cosines.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(cosines.size()) * edge_share);
    std::nth_element(cosines.begin(), at, cosines.end());
    return static_cast<double>(*at);
}

TEST(NormalsFromDepth, OfAPlaneAreThePlanes) {
    for (const auto& source : {"normal_from_depth", "normal_from_depth_accurate"}) {
        for (const glm::dvec3& n : {glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.3, 1), glm::dvec3(-1, 1, 0.8)}) {
            EXPECT_GT(
                least_cosine(plane_scene({0, 0, -3}, glm::normalize(n), 400), front_camera(), source, 0),
                0.999);
        }
    }
}

// At edges the simple differences cross from one surface to the other; the accurate ones stay on the pixel's
// side.
TEST(NormalsFromDepth, OfACornerAreRightNearlyEverywhereWhenAccurate) {
    EXPECT_GT(least_cosine(corner_scene(), corner_camera(), "normal_from_depth_accurate", 0.001), 0.99);
    EXPECT_LT(least_cosine(corner_scene(), corner_camera(), "normal_from_depth", 0.001), 0.9);
}

TEST(Normals, OfARequestReplaceTheDescribedOnes) {
    const auto methods = load_methods();
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    const CameraFrame frame(corner_camera(), 160, 90);
    const auto filters = load_filters();
    MethodRequest request = request_for(find_method(methods, "gtao"), filters, "default");
    request.filter = nullptr;
    renderer.draw_gbuffer(frame, needed_gbuffer_inputs(request));
    const ImageF geometric = renderer.run(request).raw;
    request.normals = Normals::from_depth_accurate;
    EXPECT_FALSE(needed_gbuffer_inputs(request).contains("normal_geometric"));
    renderer.draw_gbuffer(frame, needed_gbuffer_inputs(request));
    const ImageF from_depth = renderer.run(request).raw;
    double difference = 0;
    for (std::size_t i = 0; i < geometric.size(); ++i) {
        difference += static_cast<double>(std::abs(geometric.pixels[i] - from_depth.pixels[i]));
    }
    EXPECT_GT(difference, 0);
    EXPECT_LT(difference / static_cast<double>(geometric.size()), 0.01);
}

// With 16 bits between near and far and two components of the normal, the images are close, but not equal.
TEST(PackedPrecision, GivesNearlyTheSameImage) {
    const auto methods = load_methods();
    const auto filters = load_filters();
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 240, 135), gbuffer_inputs());
    const std::string before = renderer.gbuffer_digest();
    for (const char* id : {"alchemy-spiral", "gtao", "sao", "volumetric-sphere"}) {
        MethodRequest request = request_for(find_method(methods, id), filters, "default");
        request.filter = nullptr;
        const ImageF full = renderer.run(request).raw;
        request.precision = Precision::packed_rgba8;
        const ImageF packed = renderer.run(request).raw;
        double difference = 0;
        for (std::size_t i = 0; i < full.size(); ++i) {
            ASSERT_TRUE(packed.pixels[i] >= 0 && packed.pixels[i] <= 1);
            difference += static_cast<double>(std::abs(full.pixels[i] - packed.pixels[i]));
        }
        EXPECT_GT(difference, 0) << id;
        EXPECT_LT(difference / static_cast<double>(full.size()), 0.02) << id;
    }
    EXPECT_EQ(renderer.gbuffer_digest(), before);
}

// A method that shows level 3 of the depth mips on a facing plane must read the plane's depth, on corners one
// of the depths below the texel.
TEST(DepthMips, OfTheRotatedGridHoldDepthsOfThePicture) {
    const auto folder = output_dir();
    write_atomically(folder / "viewer" / "method.json", R"({"label": "v", "paper": "none", "summary": "v",
        "depth_mips": {"filter": "rotated_grid"},
        "passes": [{"fragment": "v.frag", "inputs": ["linear_depth", "depth_mips"]}]})");
    write_atomically(folder / "viewer" / "v.frag", R"(#include "contract/ao_pass.glsl"
        float visibility(vec2 image_px, vec3 position) { return -tap_mip_position(image_px, 3).z / u_far; })");
    const auto methods = load_methods(folder);
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 163, 91), {});
    const GBufferImages images = renderer.read_gbuffer();
    const ImageF level = renderer.run(request_for(find_method(methods, "viewer"), {}, "default")).raw;
    for (int y = 0; y < 88; ++y) {
        for (int x = 0; x < 160; ++x) {
            if (images.surface.at(x, y) == 0) continue;
            const float depth = level.at(x, y) * 30.0F;
            bool found = false;
            for (int j = y / 8 * 8; j < y / 8 * 8 + 8; ++j) {
                for (int i = x / 8 * 8; i < x / 8 * 8 + 8; ++i)
                    found = found || std::abs(images.linear_depth().at(i, j) - depth) < 1e-4F;
            }
            ASSERT_TRUE(found) << x << " " << y;
        }
    }
}

// Coarser levels only smooth the depths of taps: neighbouring pixels that read different levels must not
// disturb each other.
TEST(DepthMips, ChangeXegtaoLittle) {
    const auto methods = load_methods(), filters = load_filters();
    const MethodDescriptor& xegtao = find_method(methods, "xegtao");
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 240, 135), {"normal_geometric"});
    const GBufferImages images = renderer.read_gbuffer();
    const ParameterValues wide = {{"radius", 1.5}}, wide_without_mips = {{"radius", 1.5}, {"mip_offset", 16}};
    ImageF difference = renderer.run(request_for(xegtao, filters, "default", wide)).raw;
    const ImageF without = renderer.run(request_for(xegtao, filters, "default", wide_without_mips)).raw;
    for (std::size_t i = 0; i < without.size(); ++i)
        difference.pixels[i] = std::abs(difference.pixels[i] - without.pixels[i]);
    EXPECT_GT(mean_over(difference, images.surface), 0);
    EXPECT_LT(mean_over(difference, images.surface), 0.01);
}

}  // namespace
}  // namespace aoscore::testing
