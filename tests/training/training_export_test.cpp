// Pictures to learn from: nothing of a scene is in two splits, and files hold what the manifest says.
#include "training/training_export.h"

#include "core/error.h"
#include "image/image_file.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

namespace aoscore::testing {
namespace {

std::ptrdiff_t count(const std::vector<std::string>& splits, const char* split) {
    return std::ranges::count(splits, split);
}

TEST(Splits, HoldOutASixthOfTheScenesTwice) {
    std::vector<std::string> digests;
    for (int i = 0; i < 12; ++i) digests.push_back(std::string(1, static_cast<char>('a' + 7 * i % 12)));
    const std::vector<std::string> splits = splits_of(digests);
    EXPECT_EQ(count(splits, "test"), 2);
    EXPECT_EQ(count(splits, "validation"), 2);
    EXPECT_EQ(count(splits, "train"), 8);
}

TEST(Splits, OfFewScenesLeaveSomethingToLearnFrom) {
    EXPECT_EQ(splits_of({"a"}), (std::vector<std::string>{"train"}));
    EXPECT_EQ(splits_of({"b", "a"}), (std::vector<std::string>{"train", "test"}));
    EXPECT_EQ(splits_of({"c", "a", "b"}), (std::vector<std::string>{"train", "test", "validation"}));
}

TEST(Splits, KeepCopiesOfASceneTogetherWhateverTheyAreCalledAndInAnyOrder) {
    const std::vector<std::string> once = splits_of({"a", "b", "c", "d"});
    const std::vector<std::string> copied = splits_of({"d", "a", "c", "a", "b", "d"});
    EXPECT_EQ(copied[1], copied[3]);
    EXPECT_EQ(copied[0], copied[5]);
    EXPECT_EQ(copied[1], once[0]);
    EXPECT_EQ(copied[4], once[1]);
}

TEST(TrainingExport, WritesWhatItsManifestNames) {
    TrainingPlan plan;
    plan.scenes = {"pillar", "railing"};
    plan.views = 2;
    plan.width = 48;
    plan.height = 32;
    plan.samples = 16;
    const std::filesystem::path folder = output_dir() / "export";
    const nlohmann::json manifest = nlohmann::json::parse(std::ifstream(export_training(plan, folder)));
    std::set<std::string> splits;
    for (const auto& scene : manifest.at("scenes")) {
        splits.insert(scene.at("split"));
        ASSERT_EQ(scene.at("items").size(), 2U);
        for (const auto& item : scene.at("items")) {
            for (const char* kind : {"gbuffer", "truth"}) {
                const ImageFile file = read_image(folder / item.at(kind).get<std::string>());
                EXPECT_EQ(file.width, 48);
                for (const auto& [channel, meaning] : manifest.at("channels").at(kind).items()) {
                    EXPECT_NE(file.channel(channel), nullptr) << kind << " " << channel;
                    EXPECT_FALSE(meaning.get<std::string>().empty());
                }
            }
        }
    }
    EXPECT_EQ(splits, (std::set<std::string>{"test", "train"}));
}

TEST(TrainingExport, RefusesTwoScenesOfOneName) {
    TrainingPlan plan;
    plan.scenes = {"pillar", "pillar"};
    EXPECT_THROW(export_training(plan, output_dir() / "export"), Error);
}

}  // namespace
}  // namespace aoscore::testing
