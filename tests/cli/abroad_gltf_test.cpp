// Tests small glTF scenes as other programs write them, with the command and the right answer of each.
#include "image/image_file.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

namespace aoscore {
namespace {

/// The cases of the manifest that trace a glTF scene.
std::vector<nlohmann::json> gltf_cases() {
    std::vector<nlohmann::json> cases;
    std::ifstream in(testing::shared_dir() / "abroad" / "manifest.json");
    for (auto& entry : nlohmann::json::parse(in)) {
        const std::string file = entry.at("file"), command = entry.at("command");
        const bool is_gltf = file.ends_with(".gltf") || file.ends_with(".glb");
        if (is_gltf && command.starts_with("reference ")) cases.push_back(entry);
    }
    return cases;
}

struct Answer {
    double visibility = 0;
    int pixels = 0;
    std::string warnings;
};

/// Runs the command on a scene other than it names; `file` may be quoted.
Answer answer_of(std::string command, const std::string& file, const std::filesystem::path& scene,
                 const std::filesystem::path& folder) {
    command.replace(command.find(file), file.size(), "'" + scene.string() + "'");
    const auto run = testing::run_aoscore(command, folder);
    EXPECT_EQ(run.exit_code, 0) << file << ": " << run.err;
    Answer answer{.warnings = run.err};
    const ImageFile truth = read_image(folder / "x.exr");
    for (std::size_t i = 0; i < truth.channel("Y")->size(); ++i) {
        if (truth.channel("mask.Y")->pixels[i] < 0.5F) continue;
        answer.visibility += static_cast<double>(truth.channel("Y")->pixels[i]);
        ++answer.pixels;
    }
    answer.visibility /= answer.pixels;
    return answer;
}

TEST(AbroadGltf, EveryWayToWriteTheSceneGivesItsVisibility) {
    REQUIRE_SHARED_INPUTS();
    // The manifest says 0.9445 over 5036 pixels, for all files that cut away their other surfaces.
    constexpr double kVisibility = 0.9445;
    constexpr int kPixels = 5036;
    const auto cases = gltf_cases();
    const auto folder = testing::output_dir();
    EXPECT_EQ(cases.size(), 5u);
    for (const auto& entry : cases) {
        const std::string file = entry.at("file");
        if (file == "hidden.gltf") continue;
        const Answer answer =
            answer_of(entry.at("command"), file, testing::shared_dir() / "abroad" / file, folder);
        EXPECT_EQ(answer.pixels, kPixels) << file;
        EXPECT_NEAR(answer.visibility, kVisibility, 0.0005) << file;
        EXPECT_EQ(answer.warnings.find("though its name ends in") != std::string::npos,
                  file == "gltf_named.glb")
            << answer.warnings;
    }
}

TEST(AbroadGltf, AHiddenNodeIsAsIfItWereNotThere) {
    REQUIRE_SHARED_INPUTS();
    const auto abroad = testing::shared_dir() / "abroad";
    std::ifstream in(abroad / "base.gltf");
    auto without_box = nlohmann::json::parse(in);
    for (auto& node : without_box["nodes"]) {
        if (node.value("name", "") == "box") node.erase("mesh");
    }
    const std::string command = "reference hidden.gltf --size 96x64 --samples 64 --radius 1 --out x.exr";
    const auto folder = testing::output_dir();
    const Answer hidden = answer_of(command, "hidden.gltf", abroad / "hidden.gltf", folder);
    const auto scene = folder / "without_box.gltf";
    std::ofstream(scene) << without_box;
    const Answer removed = answer_of(command, "hidden.gltf", scene, folder);
    EXPECT_EQ(hidden.pixels, removed.pixels);
    EXPECT_NEAR(hidden.visibility, removed.visibility, 0.0005);
}

}  // namespace
}  // namespace aoscore
