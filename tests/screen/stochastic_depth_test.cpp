// Compares methods over several depths a texel with those over one depth that they extend.
#include "core/error.h"
#include "hand_made.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace aoscore::testing {
namespace {

constexpr std::string_view kPrefix = "sd-";

/// The method over one depth a texel that each method over several extends.
const std::vector<std::pair<std::string, std::string>>& parents() {
    static const std::vector<std::pair<std::string, std::string>> all = [] {
        std::vector<std::pair<std::string, std::string>> pairs;
        for (const std::string& id : method_ids()) {
            if (!id.starts_with(kPrefix)) continue;
            const std::string parent = id.substr(kPrefix.size());
            pairs.emplace_back(id, parent == "bitmask" ? "visibility-bitmask" : parent);
        }
        return pairs;
    }();
    return all;
}

bool tosses_coins(const std::string& sampling) {
    return std::ranges::find(depth_samplings(), sampling, &DepthSampling::id)->tosses_coins;
}

class StochasticDepth : public ::testing::Test {
  protected:
    void look_at(const Scene& scene, const CameraFrame& frame) {
        renderer_.set_scene(scene);
        renderer_.draw_gbuffer(frame, gbuffer_inputs());
    }
    void look_at_corner() { look_at(corner_scene(), CameraFrame(corner_camera(), 160, 90)); }

    ParameterValues values(const std::string& id, const ParameterValues& settings = {}) const {
        return find_method(methods_, id).values("default", settings);
    }
    ImageF run(const std::string& id, const ParameterValues& parameters, Border border = Border::far) {
        MethodRequest request;
        request.method = &find_method(methods_, id);
        request.parameters = parameters;
        request.border = border;
        return renderer_.run(request).raw;
    }
    /// Runs the parent with the values of all parameters that both have.
    ImageF run_parent(const std::string& parent, const ParameterValues& parameters,
                      Border border = Border::far) {
        ParameterValues shared = values(parent);
        for (auto& [id, value] : shared) {
            if (parameters.contains(id)) value = parameters.at(id);
        }
        return run(parent, shared, border);
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    ScreenRenderer renderer_;
};

TEST_F(StochasticDepth, EqualsItsParentBitForBitWhereEverySurfaceIsKept) {
    ASSERT_GE(parents().size(), 3U);
    const Scene atrium = load_scene("atrium");
    Camera parallel = corner_camera();
    parallel.projection = Camera::Projection::orthographic;
    parallel.half_height = 1.7;
    const std::vector<std::pair<const Scene, CameraFrame>> views = {
        {atrium, CameraFrame(find_view(atrium, "wide").camera, 160, 90)},
        {corner_scene(), CameraFrame(parallel, 97, 61)}};
    for (const auto& [scene, frame] : views) {
        look_at(scene, frame);
        for (const auto& [id, parent] : parents()) {
            for (const auto& [preset, unused] : find_method(methods_, id).presets) {
                const MethodDescriptor& method = find_method(methods_, id);
                if (!tosses_coins(method.values(preset).at("sampling").word())) continue;
                // Child and parent are tuned each for itself.
                if (method.tunings.contains(preset)) continue;
                for (const int samples : {1, 2, 16}) {
                    ParameterValues kept =
                        method.values(preset, {{"alpha", 1.0}, {"depth_samples", samples}});
                    if (kept.contains("side_cameras")) kept["side_cameras"] = 0;
                    for (const Border border : {Border::far, Border::clamp}) {
                        EXPECT_EQ(run(id, kept, border).pixels, run_parent(parent, kept, border).pixels)
                            << id << "/" << preset << " S " << samples;
                    }
                }
            }
        }
    }
}

TEST_F(StochasticDepth, EqualsItsParentWhereverItLooksAtAllDepthsIfTheyAreTheFirst) {
    look_at_corner();
    for (const auto& [id, parent] : parents()) {
        const Parameter* use = find_method(methods_, id).find_parameter("use");
        if (use == nullptr) continue;
        for (const std::string& choice : use->choices) {
            const ParameterValues kept = values(id, {{"alpha", 1.0}, {"depth_samples", 4}, {"use", choice}});
            EXPECT_EQ(run(id, kept).pixels, run_parent(parent, kept).pixels) << id << " " << choice;
        }
    }
}

// This holds also where the radius extends to the far plane, whose depth empty samples have: over a floor
// they would act as a wall.
TEST_F(StochasticDepth, IsOpenWhereAllSamplesAreEmpty) {
    Camera low = front_camera();
    low.position = {0, 0.3, 0};
    low.target = {0, 0.3, -1};
    const std::vector<std::pair<Scene, CameraFrame>> views = {
        {corner_scene(), CameraFrame(corner_camera(), 160, 90)},
        {plane_scene({0, 0, 0}, {0, 1, 0}, 500), CameraFrame(low, 160, 90)}};
    for (const auto& [scene, frame] : views) {
        look_at(scene, frame);
        for (const auto& [id, parent] : parents()) {
            const ImageF image =
                run(id, values(id, {{"alpha", 0.001}, {"depth_samples", 1}, {"radius", 1e6}}));
            EXPECT_GT(mean_over(image, Mask(image.width, image.height, 1)), 0.985) << id;
        }
    }
}

// A maximum over some of the layers is at most that over all: in a texel, and so in a sum over taps. A
// horizon that a layer raised hides later ones, so that HBAO's sum may fall.
TEST_F(StochasticDepth, OfHbaoPlusAndSsaoFindsNoMoreThanAllLayersHold) {
    look_at_corner();
    for (const char* id : {"sd-ssao", "sd-hbao-plus"}) {
        const ImageF all = run(id, values(id, {{"sampling", "peeled"}, {"depth_samples", 16}}));
        for (const int samples : {1, 4, 16}) {
            const ImageF some = run(id, values(id, {{"depth_samples", samples}}));
            for (std::size_t i = 0; i < all.size(); ++i)
                ASSERT_GE(some.pixels[i], all.pixels[i] - 1e-6F) << id << " " << samples;
        }
    }
}

TEST_F(StochasticDepth, OfSsaoLosesNothingByTheAngleSkip) {
    look_at_corner();
    const auto with = [&](const char* use) {
        return run("sd-ssao", values("sd-ssao", {{"use", use}, {"depth_samples", 2}})).pixels;
    };
    EXPECT_EQ(with("always"), with("angle_skip"));
    EXPECT_EQ(with("beyond_part"), with("beyond_part_and_angle_skip"));
    EXPECT_NE(with("always"), with("beyond_radius"));
}

/// A floor, a block that stands on it, and a screen before them that hides the block but not all of the
/// floor.
Scene hidden_block() {
    Scene scene = empty_scene();
    add_quad(scene, {-6, -1, 0}, {12, 0, 0}, {0, 0, -12});
    add_quad(scene, {-0.6, -1, -4.6}, {1.2, 0, 0}, {0, 1, 0});    // front
    add_quad(scene, {-0.6, 0, -4.6}, {1.2, 0, 0}, {0, 0, -1.2});  // top
    add_quad(scene, {-0.6, -1, -4.6}, {0, 1, 0}, {0, 0, -1.2});
    add_quad(scene, {0.6, -1, -4.6}, {0, 1, 0}, {0, 0, -1.2});
    add_quad(scene, {-0.75, -0.5, -2}, {1.2, 0, 0}, {0, 0.9, 0});
    return scene;
}

TEST_F(StochasticDepth, FindsWhatAScreenHidesTheMoreSurelyTheMoreSamplesItHas) {
    look_at(hidden_block(), CameraFrame(front_camera(), 240, 136));
    renderer_.draw_gbuffer(CameraFrame(front_camera(), 240, 136), gbuffer_inputs());
    for (const auto& [id, parent] : parents()) {
        const auto mean = [&](ParameterValues settings) {
            settings["radius"] = 1.5;
            const ImageF image = run(id, values(id, settings));
            return mean_over(image, Mask(image.width, image.height, 1));
        };
        const double one = mean({{"alpha", 1.0}, {"depth_samples", 1}});
        const double all = mean({{"sampling", "peeled"}, {"depth_samples", 8}});
        EXPECT_GT(one, all + 1e-4) << id << ": the screen hides nothing";
        const double few = mean({{"depth_samples", 2}}), many = mean({{"depth_samples", 16}});
        EXPECT_GT(few, many) << id;
        EXPECT_LT(many - all, 0.5 * (one - all)) << id;
    }
}

/// The layers of what stands still and of what moves, for each method that has them.
constexpr const char* kTwoLayers = "static-and-dynamic";

TEST_F(StochasticDepth, OfStillAndMovingThingsEqualsItsParentBitForBitWhereNothingMoves) {
    look_at_corner();
    for (const auto& [id, parent] : parents()) {
        const ParameterValues two = find_method(methods_, id).values(kTwoLayers);
        for (const Border border : {Border::far, Border::clamp})
            EXPECT_EQ(run(id, two, border).pixels, run_parent(parent, two, border).pixels) << id;
    }
}

/// A block that moves in front of a hole in a wall, so that nothing lies behind it, and far in front of it a
/// screen, if asked for, whose picture lies within the block's.
Scene moving_block(bool has_screen, bool block_moves) {
    Scene scene = empty_scene();
    add_quad(scene, {-20, -20, -6}, {18.85, 0, 0}, {0, 40, 0});
    add_quad(scene, {1.15, -20, -6}, {18.85, 0, 0}, {0, 40, 0});
    add_quad(scene, {-1.15, -20, -6}, {2.3, 0, 0}, {0, 19.17, 0});
    add_quad(scene, {-1.15, 0.83, -6}, {2.3, 0, 0}, {0, 19.17, 0});
    const std::size_t still = scene.instances.size();
    add_quad(scene, {-1, -0.7, -5.5}, {2, 0, 0}, {0, 1.4, 0});
    for (std::size_t i = still; i < scene.instances.size(); ++i) scene.instances[i].is_dynamic = block_moves;
    if (has_screen) add_quad(scene, {-0.17, -0.1, -1}, {0.34, 0, 0}, {0, 0.2, 0});
    return scene;
}

// The screen is out of every tap's radius, and all that it hides moves: what is found beside it is, to the
// bit, what one layer finds where there is no screen. SSAO weighs a nearer surface by its distance and never
// drops it.
TEST_F(StochasticDepth, OfStillAndMovingThingsFindsWhatMovesBehindAScreenAsIfThereWereNone) {
    const CameraFrame frame(front_camera(), 240, 136);
    for (const auto& [id, parent] : parents()) {
        if (parent == "ssao") continue;
        ParameterValues two = find_method(methods_, id).values(kTwoLayers, {{"radius", 0.8}});
        look_at(moving_block(false, true), frame);
        const ImageF open_depth = renderer_.read_gbuffer().linear_depth();
        const ImageF open = run_parent(parent, two);
        look_at(moving_block(true, true), frame);
        const ImageF depth = renderer_.read_gbuffer().linear_depth();
        const ImageF found = run(id, two), lost = run_parent(parent, two);
        look_at(moving_block(true, false), frame);
        const ImageF still = run(id, two);
        std::size_t behind = 0, beside = 0, hidden = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            if (depth.pixels[i] != open_depth.pixels[i]) {
                ++behind;
                continue;
            }
            ++beside;
            ASSERT_EQ(found.pixels[i], open.pixels[i]) << id;
            ASSERT_EQ(still.pixels[i], lost.pixels[i]) << id << ": nothing moves";
            hidden += lost.pixels[i] != open.pixels[i] ? 1 : 0;
        }
        EXPECT_GT(behind, depth.size() / 200) << id;
        EXPECT_GT(beside, depth.size() / 2) << id;
        EXPECT_GT(hidden, 50U) << id << ": the screen hides nothing";
    }
}

TEST_F(StochasticDepth, OfStillAndMovingThingsHasTwoLayers) {
    look_at_corner();
    try {
        run("sd-hbao", find_method(methods_, "sd-hbao").values(kTwoLayers, {{"depth_samples", 4}}));
        FAIL() << "there are no four such layers";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), ::testing::HasSubstr("2 layers, not 4"));
    }
}

/// A wall before which a box floats, its faces turned outward, or inward.
Scene box_before_wall(bool outward) {
    Scene scene = empty_scene();
    add_quad(scene, {-20, -20, -6}, {40, 0, 0}, {0, 40, 0});
    const glm::dvec3 low(-1, -0.7, -5.9), size(2, 1.4, 0.6);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 a(0), b(0), across(0);
        a[(axis + 1) % 3] = size[(axis + 1) % 3];
        b[(axis + 2) % 3] = size[(axis + 2) % 3];
        across[axis] = size[axis];
        const bool turned = !outward;
        add_quad(scene, low + across, turned ? b : a, turned ? a : b);
        add_quad(scene, low, turned ? a : b, turned ? b : a);
    }
    return scene;
}

// By the counting of faces, a point is in a solid or is not: a sheet hides nothing, however far it floats
// before the wall, nor does a box whose faces are turned inward, and one that a mirroring placement turns
// back does.
TEST_F(StochasticDepth, OfClosedMeshesHidesWhatLiesInside) {
    const CameraFrame frame(front_camera(), 160, 90);
    const auto seen = [&](const Scene& scene) {
        look_at(scene, frame);
        const MethodDescriptor& method = find_method(methods_, "sd-ssao");
        return run("sd-ssao", method.values("closed-meshes", {{"radius", 0.8}, {"depth_samples", 6}}));
    };
    const Mask all(160, 90, 1);
    Scene sheet = empty_scene();
    add_quad(sheet, {-20, -20, -6}, {40, 0, 0}, {0, 40, 0});
    add_quad(sheet, {-1, -0.7, -5.5}, {2, 0, 0}, {0, 1.4, 0});
    EXPECT_EQ(mean_over(seen(sheet), all), 1);
    EXPECT_LT(mean_over(run("ssao", values("ssao", {{"radius", 0.8}})), all), 0.99)
        << "nobody sees the sheet";

    const ImageF solid = seen(box_before_wall(true));
    EXPECT_LT(mean_over(solid, all), 0.995);
    for (int y = 0; y < 90; ++y) ASSERT_EQ(solid.at(0, y), 1) << "beyond the radius";
    EXPECT_EQ(mean_over(seen(box_before_wall(false)), all), 1);

    Scene mirrored = box_before_wall(false);
    for (Mesh& mesh : mirrored.meshes) {
        for (glm::vec3& p : mesh.positions) p.x = -p.x;
    }
    for (Instance& instance : mirrored.instances) instance.scene_from_mesh[0] *= -1.0;
    EXPECT_EQ(seen(mirrored).pixels, solid.pixels);

    try {
        run("sd-ssao", values("sd-ssao", {{"closed_meshes", true}}));
        FAIL() << "stochastic samples are in no order";
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), ::testing::HasSubstr("peeled layers alone"));
    }
}

}  // namespace
}  // namespace aoscore::testing
