// Tests cameras of the user's own: view files, one on the command line, and those that the program prints for
// reuse.
#include "core/files.h"
#include "image/image_file.h"
#include "results/results.h"
#include "results/view_piece.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_aoscore;

/// A floor from (-2, 0, -2) to (2, 0, 2) as a glTF file, with camera nodes at these places that look down -z.
void write_floor(const fs::path& file, const std::vector<std::vector<double>>& cameras = {}) {
    const float corners[] = {-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2};
    const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
    const fs::path buffer = fs::path(file).replace_extension(".bin");
    std::ofstream(buffer, std::ios::binary)
        .write(reinterpret_cast<const char*>(corners), sizeof corners)
        .write(reinterpret_cast<const char*>(indices), sizeof indices);
    json document = {
        {"asset", {{"version", "2.0"}}},
        {"buffers", {{{"uri", buffer.filename().string()}, {"byteLength", sizeof corners + sizeof indices}}}},
        {"bufferViews",
         {{{"buffer", 0}, {"byteLength", sizeof corners}},
          {{"buffer", 0}, {"byteOffset", sizeof corners}, {"byteLength", sizeof indices}}}},
        {"accessors",
         {{{"bufferView", 0},
           {"componentType", 5126},
           {"count", 4},
           {"type", "VEC3"},
           {"min", {-2, 0, -2}},
           {"max", {2, 0, 2}}},
          {{"bufferView", 1}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}}},
        {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"scenes", {{{"nodes", {0}}}}}};
    for (const std::vector<double>& place : cameras) {
        document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
        document["scenes"][0]["nodes"].push_back(document["nodes"].size());
        document["nodes"].push_back({{"camera", 0}, {"translation", place}});
    }
    std::ofstream(file) << document.dump();
}

json view_file(const std::vector<std::string>& ids) {
    json file = {{"title", "A floor"},
                 {"verified", true},
                 {"bounds", {{"low", {-2, 0, -2}}, {"high", {2, 0, 2}}, {"tolerance_m", 0.01}}},
                 {"views", json::array()}};
    for (const std::string& id : ids) {
        file["views"].push_back({{"id", id},
                                 {"position", {0, 3, 3}},
                                 {"target", {0, 0, 0}},
                                 {"fovy_deg", 50},
                                 {"near_m", 0.1},
                                 {"far_m", 20},
                                 {"radius_m", 0.5}});
    }
    return file;
}

std::vector<std::string> ids_in(const std::string& listed) {
    std::vector<std::string> ids;
    const json file = json::parse(listed);
    for (const json& view : file.at("views")) ids.push_back(view.at("id"));
    return ids;
}

std::vector<std::string> views_scored(const fs::path& folder) {
    std::vector<std::string> views;
    for (const ViewRecord& view : read_results(folder).views) views.push_back(view.view);
    return views;
}

constexpr const char* kQuick = " --size 48x32 --samples 4 --methods ssao --out ";

TEST(OwnViews, BesideTheSceneAreFoundAndGoBeforeItsCameras) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf", {{0, 1, 3}});
    std::ofstream(folder / "floor.views.json") << view_file({"high", "low"});
    const auto run = run_aoscore(std::string("score floor.gltf") + kQuick + "a", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(views_scored(folder / "a"), ElementsAre("high", "low")) << "kinds are not mixed";
    EXPECT_THAT(run.err, HasSubstr("taking 2 views of floor.views.json, not its 1 camera node "
                                   "(--view nodes for it, --view all for all)"));
    const auto all = run_aoscore(std::string("score floor.gltf --view all") + kQuick + "b", folder);
    ASSERT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(views_scored(folder / "b").size(), 3u);
    const auto nodes = run_aoscore(std::string("score --view nodes,low floor.gltf") + kQuick + "c", folder);
    ASSERT_EQ(nodes.exit_code, 0) << nodes.err;
    EXPECT_THAT(views_scored(folder / "c"), ElementsAre("camera", "low"));
}

TEST(OwnViews, OfANamedFileReplaceThoseThatAreFound) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf");
    std::ofstream(folder / "floor.views.json") << view_file({"found"});
    std::ofstream(folder / "mine.json") << view_file({"mine"});
    const auto run =
        run_aoscore("reference floor.gltf --views mine.json --size 48x32 --samples 4 --out t.exr", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const ImageFile truth = read_image(folder / "t.exr");
    EXPECT_EQ(truth.attributes.at("aoscore:view"), "mine");
    const std::string& again = truth.attributes.at("comments");
    EXPECT_THAT(again, HasSubstr(" --views mine.json --view mine "));
    ASSERT_EQ(run_aoscore(again.substr(again.find(' ')), folder).exit_code, 0) << again;

    json other = view_file({"mine"});
    other["bounds"]["high"] = {3, 0, 2};
    std::ofstream(folder / "mine.json") << other;
    const auto refused = run_aoscore("gbuffer floor.gltf --views mine.json --out g.exr", folder);
    EXPECT_EQ(refused.exit_code, 4) << "named, but for another scene";
    EXPECT_THAT(refused.err, HasSubstr("mine.json"));
    std::ofstream(folder / "floor.views.json") << other;
    const auto warned = run_aoscore("list views floor.gltf", folder);
    EXPECT_EQ(warned.exit_code, 0);
    EXPECT_THAT(warned.err, HasSubstr("floor.views.json is for a scene with bounds"));
}

TEST(OwnViews, OneOnTheCommandLineSeesWhatAFileWithItsNumbersShows) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf");
    const std::string camera = " --eye -0.5,2,2.5 --target 0,0,0.25 --fovy 40 ";
    const auto listed = run_aoscore("list views floor.gltf" + camera, folder);
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    std::ofstream(folder / "floor.views.json") << listed.out;
    const json eye = json::parse(listed.out).at("views").at(0);
    EXPECT_EQ(eye.at("position"), json({-0.5, 2, 2.5}));
    EXPECT_NEAR(eye.at("fovy_deg").get<double>(), 40, 1e-9);
    const std::string size = " --size 48x32 --samples 4 --radius 1 --out ";
    ASSERT_EQ(run_aoscore("reference floor.gltf" + camera + size + "a.exr", folder).exit_code, 0);
    ASSERT_EQ(run_aoscore("reference floor.gltf --view eye" + size + "b.exr", folder).exit_code, 0);
    const ImageFile a = read_image(folder / "a.exr"), b = read_image(folder / "b.exr");
    EXPECT_EQ(a.channel("mask.Y")->pixels, b.channel("mask.Y")->pixels);
    EXPECT_EQ(a.attributes.at("worldToCamera"), b.attributes.at("worldToCamera"));
    EXPECT_THAT(a.attributes.at("comments"), HasSubstr(" --eye -0.5,2,2.5 --target 0,0,0.25 --fovy 40 "));
    const auto down =
        run_aoscore("gbuffer floor.gltf --eye 0,4,0 --target 0,0,0 --size 8x8 --out d.exr", folder);
    EXPECT_EQ(down.exit_code, 0) << "straight down: " << down.err;
}

TEST(OwnViews, WithNumbersThatNoPictureCanBeMadeOfAreRefused) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf");
    for (const char* camera :
         {"--eye 1,2 --target 0,0,0", "--eye 1,2,3", "--target 1,2,3", "--fovy 40",
          "--eye 1,2,3 --target 1,2,3", "--eye 1,2,x --target 0,0,0", "--eye 1,2,3, --target 0,0,0",
          "--eye nan,2,3 --target 0,0,0", "--eye 1e39,2,3 --target 0,0,0", "--eye 3e38,2,3 --target 0,0,0",
          "--eye 1,2,3 --target 0,0,1e9", "--eye 1,2,3 --target 0,0,0 --fovy 180",
          "--eye 1,2,3 --target 0,0,0 --view eye"}) {
        const auto run =
            run_aoscore("gbuffer floor.gltf --size 8x8 --out g.exr " + std::string(camera), folder);
        EXPECT_EQ(run.exit_code, 64) << camera << "\n" << run.err;
    }
    for (const double far_away : {-1e308, 1.8446744073709552e19, 3.5e38, 1e39, 1e9}) {
        for (const char* key : {"position", "target"}) {
            json file = view_file({"far"});
            file["views"][0][key][0] = far_away;
            std::ofstream(folder / "floor.views.json") << file;
            const auto run = run_aoscore("score floor.gltf" + std::string(kQuick) + "o", folder);
            EXPECT_EQ(run.exit_code, 4) << key << " " << far_away << "\n" << run.err;
            EXPECT_THAT(run.err, AnyOf(HasSubstr("far"), HasSubstr(std::string("views[0].") + key)));
        }
    }
    json near = view_file({"near"});
    near["views"][0]["near_m"] = 1e-300;
    std::ofstream(folder / "floor.views.json") << near;
    EXPECT_EQ(run_aoscore("gbuffer floor.gltf --out g.exr", folder).exit_code, 4);
    fs::remove(folder / "floor.views.json");
    write_floor(folder / "floor.gltf", {{3.4e38, 0, 0}, {0, 1, 3}});
    const auto nodes = run_aoscore("list views floor.gltf", folder);
    EXPECT_EQ(nodes.exit_code, 0);
    EXPECT_EQ(ids_in(nodes.out).size(), 1u) << "a camera that cannot be used is left out";
    EXPECT_THAT(nodes.err, HasSubstr("is left out"));
}

TEST(OwnViews, AreNamedAsTheRemedyWhereASceneHasNoCamera) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf");
    write_floor(folder / "seen.gltf", {{0, 1, 1}});
    for (const char* command : {"gbuffer %.gltf --size 32x18 --out %.exr",
                                "score %.gltf --size 32x18 --samples 2 --methods alchemy --out %"}) {
        for (const std::string scene : {"floor", "seen"}) {
            std::string words = command;
            for (auto at = words.find('%'); at != std::string::npos; at = words.find('%'))
                words.replace(at, 1, scene);
            const auto run = run_aoscore(words, folder);
            EXPECT_EQ(run.err.find("has no camera: taking") != std::string::npos, scene == "floor")
                << words << "\n"
                << run.err;
        }
    }
}

TEST(OwnViews, AreListedAsAFileThatGivesTheSameViewsAgain) {
    const fs::path folder = output_dir();
    for (const char* scene : {"plane", "pit", "atrium"}) {
        const auto listed = run_aoscore(std::string("list views ") + scene, folder);
        ASSERT_EQ(listed.exit_code, 0) << listed.err;
        std::ofstream(folder / "again.json") << listed.out;
        const auto again = run_aoscore(std::string("list views ") + scene + " --views again.json", folder);
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_EQ(again.out, listed.out);
    }
}

TEST(ViewPiece, OfACropShowsThatPartOfThePicture) {
    ViewRecord view;
    view.view = "whole";
    view.position_m = {0, 0, 0};
    view.target_m = {0, 0, -2};
    view.up = {0, 1, 0};
    view.projection = "perspective";
    view.width = 200;
    view.height = 100;
    view.fovy_deg = 90;
    // The right half of the upper half: its middle is half a picture's height to the right and a quarter up.
    const json crop = crop_piece(view, {100, 0, 100, 50}, "part");
    const std::vector<double> target = crop.at("target");
    EXPECT_NEAR(target[0] / -target[2], 1, 1e-12);
    EXPECT_NEAR(target[1] / -target[2], 0.5, 1e-12);
    EXPECT_NEAR(std::hypot(target[0], target[1], target[2]), 2, 1e-12) << "as far as the view's target";
    // Half the crop's height is half the picture's, seen from 3/2 as far as the picture's middle.
    EXPECT_NEAR(std::tan(crop.at("fovy_deg").get<double>() * M_PI / 360), 0.5 / 1.5, 1e-12);
    EXPECT_EQ(crop.at("id"), "part");

    view.projection = "orthographic";
    view.half_height_m = 5;
    const json moved = crop_piece(view, {100, 0, 100, 50}, "part");
    EXPECT_EQ(moved.at("position"), json({5.0, 2.5, 0.0}));
    EXPECT_EQ(moved.at("target"), json({5.0, 2.5, -2.0}));
    EXPECT_EQ(moved.at("half_height_m"), 2.5);
}

TEST(Score, OfACameraThatSeesNothingEndsWith2AndSaysSo) {
    const fs::path folder = output_dir();
    write_floor(folder / "floor.gltf");
    const std::string command = "score floor.gltf --eye 0,1,3 --target 0,1,9" + std::string(kQuick) + "o";
    for (const char* when : {"measured", "from the store"}) {
        const auto run = run_aoscore(command, folder);
        EXPECT_EQ(run.exit_code, 2) << when << run.err;
        EXPECT_THAT(run.err, HasSubstr("floor/eye: the camera sees no surface")) << when;
    }
    EXPECT_THAT(read_file(folder / "o/index.html"), HasSubstr("the camera sees no surface"));
    const auto some =
        run_aoscore("score floor.gltf --eye 0,1,3 --target 0,0,0" + std::string(kQuick) + "p", folder);
    EXPECT_EQ(some.exit_code, 0) << some.err;
    EXPECT_THAT(some.err, Not(HasSubstr("sees no surface")));
}

}  // namespace
}  // namespace aoscore
