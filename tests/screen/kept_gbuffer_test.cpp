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

}  // namespace
}  // namespace aoscore::testing
