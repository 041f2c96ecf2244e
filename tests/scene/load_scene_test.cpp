#include "core/error.h"
#include "gltf_file.h"
#include "scene/gltf/asset_folder.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

namespace fs = std::filesystem;
using aoscore::Error;
using aoscore::ExitCode;
using aoscore::Scene;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;

ExitCode exit_code_of(const std::string& name) {
    try {
        aoscore::load_scene(name);
        return ExitCode::ok;
    } catch (const Error& error) {
        return error.exit_code();
    }
}

TEST(LoadScene, AnUnknownNameIsAMistakeOfTheUserAndAMissingFileOne) {
    EXPECT_EQ(exit_code_of("no_such_scene"), ExitCode::usage);
    EXPECT_EQ(exit_code_of("no_such_scene.glb"), ExitCode::file_error);
    EXPECT_EQ(exit_code_of("folder/no_such_scene"), ExitCode::file_error);
    EXPECT_EQ(exit_code_of(output_dir().string()), ExitCode::file_error);
    try {
        aoscore::load_scene("no_such_scene");
    } catch (const Error& error) {
        for (const auto& scene : aoscore::builtin_scenes()) {
            EXPECT_NE(error.valid().find(scene.id), std::string::npos) << scene.id;
        }
    }
}

TEST(LoadScene, TheDigestFollowsGeometryTransformsAndCutOuts) {
    const auto folder = output_dir();
    const auto digest = [&](float high, double x, double alpha) {
        GltfFile file;
        file.document["materials"] = {
            {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}}};
        file.add_box({0, 0, 0}, {1, 1, high});
        file.document["meshes"][0]["primitives"][0]["material"] = 0;
        file.add_node({{"mesh", 0}, {"translation", {x, 0, 0}}});
        return file.load(folder).digest;
    };
    const std::string first = digest(1, 0, 1);
    EXPECT_EQ(digest(1, 0, 1), first);
    EXPECT_NE(digest(1.0001f, 0, 1), first);
    EXPECT_NE(digest(1, 1e-9, 1), first);
    EXPECT_NE(digest(1, 0, 0.2), first);
}

TEST(LoadScene, TheIdIsTheFilesStem) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    const Scene scene = aoscore::load_scene(file.write(output_dir(), "small room").string());
    EXPECT_EQ(scene.id, "small room");
    EXPECT_EQ(scene.file.filename(), "small room.gltf");
}

TEST(AssetFolder, SymbolicLinksThatLeadOutAreNotFollowed) {
    const fs::path folder = output_dir();
    fs::create_directories(folder / "asset");
    std::ofstream(folder / "secret.bin") << "secret";
    fs::create_symlink("../secret.bin", folder / "asset" / "link.bin");
    fs::create_symlink("..", folder / "asset" / "up");
    std::ofstream(folder / "asset" / "own.bin") << "own";
    fs::create_symlink("own.bin", folder / "asset" / "alias.bin");
    const aoscore::gltf::AssetFolder asset(folder / "asset" / "room.gltf");
    EXPECT_EQ(asset.read("own.bin", "x"), "own");
    EXPECT_EQ(asset.read("%6Fwn.bin", "x"), "own");
    EXPECT_EQ(asset.read("./alias.bin", "x"), "own");
    EXPECT_THROW(asset.read("link.bin", "x"), Error);
    EXPECT_THROW(asset.read("up/secret.bin", "x"), Error);
    EXPECT_THROW(asset.read("up/asset/../secret.bin", "x"), Error);
    EXPECT_THROW(asset.read(".", "x"), Error);
}

TEST(AssetFolder, OnlyRelativePathsWithinTheFolderPass) {
    for (const char* good : {"a.bin", "b/a.bin", "b/../a.bin", "in%20side.bin", "%C3%A4.bin", "100%.bin"}) {
        EXPECT_NO_THROW(aoscore::gltf::check_relative_uri(good, "x")) << good;
    }
    for (const char* bad :
         {"", "/etc/passwd", "../a.bin", "b/../../a.bin", "%2e%2e/a.bin", "..%2fa.bin", "file:///a",
          "http://h/a", "C:a.bin", "b\\a.bin", "%5c..%5ca", "a%00.bin", "a%0a.bin", "%2Fetc"}) {
        EXPECT_THROW(aoscore::gltf::check_relative_uri(bad, "x"), Error) << bad;
    }
}

TEST(DataUri, DecodesBase64AndNothingElse) {
    using aoscore::gltf::decode_data_uri;
    EXPECT_EQ(decode_data_uri("data:;base64,", "x"), "");
    EXPECT_EQ(decode_data_uri("data:application/octet-stream;base64,QQ==", "x"), "A");
    EXPECT_EQ(decode_data_uri("data:a/b;base64,QUI=", "x"), "AB");
    EXPECT_EQ(decode_data_uri("data:a/b;base64,QUJD", "x"), "ABC");
    EXPECT_EQ(decode_data_uri("data:a/b;base64,+/+/", "x"), "\xFB\xFF\xBF");
    for (const char* bad : {"data:a/b,QUJD", "data:a/b;base64", "data:a/b;base64,Q", "data:a/b;base64,Q*JD",
                            "data:a/b;base64,Q=JD"}) {
        EXPECT_THROW(decode_data_uri(bad, "x"), Error) << bad;
    }
}

}  // namespace
