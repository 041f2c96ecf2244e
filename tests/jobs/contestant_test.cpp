// Tests the inputs that contestants state, and contestants that no shader draws.
#include "jobs/contest/contestant.h"

#include "core/error.h"
#include "jobs/contest/few_rays.h"
#include "jobs/contest/folder_image.h"
#include "jobs/contest/truth_image.h"
#include "jobs/view_jobs.h"
#include "jobs/view_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace aoscore {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Contestants : public ::testing::Test {
  protected:
    Contestants() {
        tools.choose(scene);
        few_rays.parameters = few_rays_method.values("default");
        few_rays.method = &few_rays_method;
        shaders.method = &find_method(methods, "alchemy");
        shaders.parameters = shaders.method->values("default");
        folder.images["oblique"] = "absent.exr";
    }

    /// The kinds of the inputs of the image of a view's only cell.
    std::vector<std::string> read_by(const std::shared_ptr<const Contestant>& contestant) {
        const ViewJobs jobs =
            view_jobs(work({{.id = "cell", .contestant = contestant, .own = {}, .timed = {}}}));
        std::vector<std::string> kinds;
        for (const Key& key : jobs.graph.at(jobs.cells[0].image).inputs)
            kinds.emplace_back(id_of(jobs.graph.at(key).kind));
        EXPECT_EQ(jobs.cells[0].times.has_value(), contestant->timed_request() != nullptr);
        EXPECT_EQ(jobs.cells[0].fetches.has_value(), contestant->timed_request() != nullptr);
        return kinds;
    }

    ViewWork work(std::vector<CellWork> cells, int width = 48) {
        return {.scene = scene,
                .view = view,
                .tools = tools,
                .gl_renderer = "",
                .gl_version = "",
                .width = width,
                .height = 32,
                .key = "wall/oblique",
                .radius_m = query.radius_m,
                .queries = {query},
                .truth = {},
                .cells = std::move(cells),
                .fixed_pass = shaders,
                .timing_goal = {},
                .kept_inputs = {},
                .truth_cache = {},
                .command = {},
                .folder = {}};
    }

    Truth traced() {
        TruthSettings settings;
        settings.samples = 16;
        settings.extras.one_layer_bound = true;
        return tools.reference().trace(frame, {query}, settings, "truth");
    }

    const Scene scene = load_scene("wall");
    const View& view = find_view(scene, "oblique");
    const CameraFrame frame{view.camera, 48, 32};
    const TruthQuery query{Falloff::binary, 0.5, 0};
    const std::vector<MethodDescriptor> methods = load_methods();
    const MethodDescriptor few_rays_method = few_rays_descriptor();
    MethodRequest shaders, few_rays;
    OutsideMethod folder;
    SceneTools tools;
};

TEST_F(Contestants, AreMadeOfWhatTheyReadAndOfNothingElse) {
    EXPECT_THAT(read_by(contestant_of(shaders)), ElementsAre("gbuffer"));
    EXPECT_THAT(read_by(contestant_of(few_rays)), ElementsAre("gbuffer")) << "its filter reads it";
    EXPECT_THAT(read_by(true_image(query)), ElementsAre("truth"));
    EXPECT_THAT(read_by(one_layer_bound(query)), ElementsAre("truth"));
    EXPECT_THAT(read_by(folder_image(folder, "oblique")), IsEmpty());
}

// An image of a folder is kept under a key that knows neither camera nor scene, but must not be served for a
// view of another size.
TEST_F(Contestants, HaveImagesOfTheViewsSize) {
    const auto key = [&](int width) {
        const ViewWork view_work = work(
            {{.id = "cell", .contestant = folder_image(folder, "oblique"), .own = {}, .timed = {}}}, width);
        return ViewKeys(view_work).image(view_work.cells[0]);
    };
    EXPECT_EQ(key(48), key(48));
    EXPECT_NE(key(48), key(64));
}

TEST_F(Contestants, ThatAreTheTruthDifferFromItByNothing) {
    const Truth truth = traced();
    const MethodOutput output = true_image(query)->image({tools, frame, &truth});
    EXPECT_EQ(output.visibility.pixels, truth.visibility[0].pixels);
    EXPECT_THROW(true_image({Falloff::binary, 0.25, 0})->image({tools, frame, &truth}), Error);
}

// The occluders in one depth layer are a part of all occluders.
TEST_F(Contestants, ThatKnowOneLayerFindNoMoreOcclusionThanThereIs) {
    const Truth truth = traced();
    const ImageF bound = one_layer_bound(query)->image({tools, frame, &truth}).visibility;
    double hidden = 0;
    for (std::size_t i = 0; i < bound.size(); ++i) {
        EXPECT_GE(bound.pixels[i], truth.visibility[0].pixels[i] - 1e-6F);
        EXPECT_LE(bound.pixels[i], 1);
        hidden += static_cast<double>(bound.pixels[i] - truth.visibility[0].pixels[i]);
    }
    EXPECT_GT(hidden, 0) << "this view hides nothing: the test tells nothing";
    Truth without = truth;
    without.one_layer_bound = {};
    EXPECT_THROW(one_layer_bound(query)->image({tools, frame, &without}), Error);
}

}  // namespace
}  // namespace aoscore
