// G-buffers that are kept give the same pictures as those just drawn, whatever was drawn in between.
#include "core/error.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <gtest/gtest.h>

namespace aoscore::testing {
namespace {

TEST(KeptGBuffers, GiveTheSamePicturesAsWhenTheyWereDrawn) {
    const auto methods = load_methods();
    MethodRequest request;
    request.method = &find_method(methods, "gtao");
    request.parameters = request.method->values("default");
    request.normals = Normals::from_depth;  // made anew for every G-buffer
    ScreenRenderer renderer;
    std::vector<std::size_t> kept;
    std::vector<ImageF> pictures;
    for (const char* id : {"pillar", "sphere"}) {
        const Scene scene = load_scene(id);
        renderer.set_scene(scene);
        for (const View& view : scene.views) {
            renderer.draw_gbuffer(CameraFrame(view.camera, 64, 36), {"normal_geometric"});
            pictures.push_back(renderer.run(request).raw);
            kept.push_back(renderer.keep_gbuffer());
            EXPECT_EQ(renderer.keep_gbuffer(), kept.back()) << "kept once";
        }
    }
    const std::uint64_t drawn = renderer.work().gbuffers;
    for (const std::size_t i : {0U, 3U, 1U, 1U, 2U, 0U}) {
        renderer.use_gbuffer(kept.at(i));
        EXPECT_EQ(renderer.run(request).raw.pixels, pictures.at(i).pixels) << i;
    }
    EXPECT_NE(pictures[0].pixels, pictures[1].pixels);
    EXPECT_EQ(renderer.work().gbuffers, drawn);
    EXPECT_THROW(renderer.use_gbuffer(99), Error);
}

// Layers are kept with their G-buffer: none is drawn twice, and none is of another scene.
TEST(KeptGBuffers, KeepTheirDepthLayers) {
    const auto methods = load_methods();
    ScreenRenderer renderer;
    for (const char* id : {"sd-hbao", "multi-view-hbao"}) {
        MethodRequest request;
        request.method = &find_method(methods, id);
        request.parameters = request.method->values("default");
        std::vector<std::size_t> kept;
        std::vector<ImageF> pictures;
        for (const char* scene_id : {"pillar", "sphere"}) {
            const Scene scene = load_scene(scene_id);
            renderer.set_scene(scene);
            renderer.draw_gbuffer(CameraFrame(scene.views.front().camera, 64, 36),
                                  needed_gbuffer_inputs(request));
            pictures.push_back(renderer.run(request).raw);
            kept.push_back(renderer.keep_gbuffer());
        }
        EXPECT_NE(pictures[0].pixels, pictures[1].pixels);
        const std::uint64_t drawn = renderer.work().layered_pictures;
        for (const std::size_t i : {0U, 1U, 0U}) {
            renderer.use_gbuffer(kept.at(i));
            EXPECT_EQ(renderer.run(request).raw.pixels, pictures.at(i).pixels) << id << " " << i;
        }
        EXPECT_EQ(renderer.work().layered_pictures, drawn) << id;
        // Others are drawn of the scene that the G-buffer shows, not of the one that was set last.
        renderer.use_gbuffer(kept.at(0));
        request.seed = 2;
        const ImageF with_others = renderer.run(request).raw;
        EXPECT_GT(renderer.work().layered_pictures, drawn) << id;
        const Scene first = load_scene("pillar");
        renderer.set_scene(first);
        renderer.draw_gbuffer(CameraFrame(first.views.front().camera, 64, 36),
                              needed_gbuffer_inputs(request));
        EXPECT_EQ(renderer.run(request).raw.pixels, with_others.pixels) << id;
    }
}

}  // namespace
}  // namespace aoscore::testing
