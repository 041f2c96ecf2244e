#include "builtin_table.h"
#include "core/files.h"
#include "core/folders.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "scene/view_file.h"
#include "support/support.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 96, kHeight = 54;

std::vector<fs::path> shipped_view_files() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& folder : fs::directory_iterator(data_dir() / "scenes")) {
        if (folder.is_directory()) files.push_back(folder.path() / "views.json");
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Expects that the filed views of a loaded scene see something, and do not lie in a wall.
void expect_good_views(const Scene& scene) {
    EXPECT_THAT(scene.warnings,
                ::testing::Not(::testing::Contains(::testing::HasSubstr("its views are not used"))));
    const ReferenceScene reference(scene);
    int filed = 0;
    for (const View& view : scene.views) {
        if (!view.source.starts_with("scenes/")) continue;
        ++filed;
        const PrimaryHits hits = reference.primary_hits(CameraFrame(view.camera, kWidth, kHeight));
        const auto seen = std::count(hits.surface.pixels.begin(), hits.surface.pixels.end(), 1);
        EXPECT_GT(seen, kWidth * kHeight / 4) << scene.id << "/" << view.id << " sees next to nothing";
        std::vector<float> depths;
        for (std::size_t i = 0; i < hits.surface.size(); ++i) {
            if (hits.surface.pixels[i] != 0) depths.push_back(hits.depth.pixels[i]);
        }
        if (depths.empty()) continue;
        const auto [nearest, farthest] = std::minmax_element(depths.begin(), depths.end());
        EXPECT_GT(static_cast<double>(*nearest), 2 * view.camera.near)
            << view.id << " is cut by its near plane";
        EXPECT_LT(static_cast<double>(*farthest), 0.95 * view.camera.far)
            << view.id << " is cut by its far plane";
    }
    EXPECT_GT(filed, 0) << scene.id;
}

class BuiltinViews : public testing::EveryBuiltin {};

TEST_P(BuiltinViews, ComeFromAVerifiedFileAndSeeTheScene) {
    const Scene scene = load_scene(std::string(GetParam().id));
    const ViewFile file = read_view_file(view_file_path(scene.id));
    for (const View& view : file.views) {
        EXPECT_TRUE(view.note.empty()) << view.note;
        EXPECT_TRUE(view.radius_m) << view.id;
    }
    expect_good_views(scene);
}

AOSCORE_FOR_EVERY_BUILTIN(BuiltinViews);

TEST(AtriumViews, AreTheWideShotAndTheCloseUp) {
    const Scene scene = load_scene("atrium");
    EXPECT_EQ(find_view(scene, "wide").radius_m, 0.5);
    EXPECT_EQ(find_view(scene, "close").radius_m, 0.5);
}

/// Share of pixels whose surface lies in the box.
double share_inside(const Scene& scene, const View& view, const glm::dvec3& low, const glm::dvec3& high) {
    const CameraFrame frame(view.camera, 320, 180);
    const PrimaryHits hits = ReferenceScene(scene).primary_hits(frame);
    int inside = 0;
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            if (hits.surface.at(x, y) == 0) continue;
            const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
            const glm::dvec3 p = ray.origin + ray.direction * static_cast<double>(hits.depth.at(x, y));
            inside +=
                p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
        }
    }
    return inside / (320.0 * 180);
}

TEST(PillarViews, HideTheMiddleCrateInMainAndShowItFromAside) {
    const Scene scene = load_scene("pillar");
    // The crates' space: just above the floor, just off the back wall.
    const glm::dvec3 low(-1, 0.01, 0.01), high(1, 2.5, 1.5);
    EXPECT_EQ(share_inside(scene, find_view(scene, "main"), low, high), 0.0);
    EXPECT_GT(share_inside(scene, find_view(scene, "moved"), low, high), 0.01);
}

TEST(PillarViews, DarkenTheWallBesideThePillarThatHidesTheCrate) {
    const Scene scene = load_scene("pillar");
    const View& main = find_view(scene, "main");
    const CameraFrame frame(main.camera, 320, 180);
    const Truth truth =
        ReferenceScene(scene).trace(frame, {{Falloff::binary, *main.radius_m, 0}}, TruthSettings{}, "pillar");
    // Points on the back wall at the height of the lowest crate: as near to it as the pillar allows, and far
    // from all.
    double beside = 0, open = 0;
    int beside_count = 0, open_count = 0;
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            if (truth.hits.surface.at(x, y) == 0) continue;
            const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
            const glm::dvec3 p = ray.origin + ray.direction * static_cast<double>(truth.hits.depth.at(x, y));
            if (std::abs(p.z) > 1e-3 || p.y < 0.55 || p.y > 0.8) continue;
            const double v = static_cast<double>(truth.visibility[0].at(x, y));
            if (std::abs(p.x) < 0.75) beside += v, ++beside_count;
            if (std::abs(std::abs(p.x) - 1.5) < 0.2) open += v, ++open_count;
        }
    }
    ASSERT_GT(beside_count, 20);
    ASSERT_GT(open_count, 20);
    EXPECT_LT(beside / beside_count, 0.8);
    EXPECT_GT(open / open_count, 0.97);
}

/// Counts the surfaces that the ray through the picture's middle meets nearer than `end`.
int layers_before(const Scene& scene, const View& view, double end) {
    const ReferenceScene reference(scene);
    Camera camera = view.camera;
    int layers = 0;
    for (; layers < 100; ++layers) {
        const PrimaryHits hits = reference.primary_hits(CameraFrame(camera, 3, 3));
        if (hits.surface.at(1, 1) == 0) break;
        const auto depth = static_cast<double>(hits.depth.at(1, 1));
        if (depth > end) break;
        camera.near = depth + 1e-4;
    }
    return layers;
}

TEST(LayersViews, LookAtScreensOfAsManyLayersAsTheirNamesSay) {
    const Scene scene = load_scene("layers");
    for (const int layers : {2, 4, 8, 16, 32}) {
        // The screens stand 7 m from the camera; behind them, at 10.2 m, are the crates.
        EXPECT_EQ(layers_before(scene, find_view(scene, "layers_" + std::to_string(layers)), 9), layers);
    }
}

TEST(LayersViews, HideTheCratesOfTheirBay) {
    const Scene scene = load_scene("layers");
    for (int bay = 0; bay < 5; ++bay) {
        const double x = 4.0 * (bay - 2);
        const View& view = find_view(scene, "layers_" + std::to_string(2 << bay));
        EXPECT_EQ(share_inside(scene, view, {x - 0.6, 0.01, 0.01}, {x + 0.6, 2.5, 1}), 0.0) << view.id;
    }
}

TEST(GrazingViews, SeeTheBoardsSidesOnlyWhereTheyTurn) {
    const Scene scene = load_scene("grazing");
    const auto side = [&](const char* id) {
        return share_inside(scene, find_view(scene, id), {0.045, 0.01, 0.01}, {0.055, 2, 1.19});
    };
    EXPECT_LT(side("edge_on"), 1e-3);
    EXPECT_GT(side("edge_10"), 0.01);
}

TEST(ShippedViews, AreReadableAndSayWhenNobodyVerifiedThem) {
    const std::vector<fs::path> files = shipped_view_files();
    EXPECT_GE(files.size(), builtin_scenes().size());
    for (const fs::path& path : files) {
        const ViewFile file = read_view_file(path);
        EXPECT_FALSE(file.title.empty()) << path;
        for (const View& view : file.views) {
            EXPECT_TRUE(view.note.empty() || view.note.starts_with("unverified: "))
                << path << ": " << view.note;
        }
    }
}

TEST(ShippedViews, FitTheWellKnownScenesThatAreHere) {
    REQUIRE_SHARED_INPUTS();
    int met = 0;
    for (const fs::path& path : shipped_view_files()) {
        const fs::path scene_file =
            testing::shared_dir() / "scenes" / (path.parent_path().filename().string() + ".glb");
        if (!fs::exists(scene_file)) continue;
        SCOPED_TRACE(scene_file.filename().string());
        ++met;
        for (const View& view : read_view_file(path).views) EXPECT_TRUE(view.note.empty()) << view.note;
        expect_good_views(load_scene(scene_file.string()));
    }
    EXPECT_GE(met, 8);
}

}  // namespace
}  // namespace aoscore
