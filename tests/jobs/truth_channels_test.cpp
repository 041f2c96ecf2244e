// Holds the table of the truth's channels: its names are unique, documented, and written as it says.
#include "jobs/truth_channels.h"

#include "core/files.h"
#include "image/image_file.h"
#include "jobs/image_output.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace aoscore::testing {
namespace {

using ::testing::HasSubstr;

TEST(TruthChannels, HaveNamesOfTheirOwnWhichTheReadmeOfTruthsLists) {
    const std::string text = read_file(source_dir() / "references" / "README.md");
    std::set<std::string> ids, names;
    for (const TruthChannel& channel : truth_channels()) {
        EXPECT_TRUE(ids.insert(channel.id).second) << channel.id;
        EXPECT_NE(!channel.number, !channel.direction) << channel.id;
        for (const std::string& name : channel.exr_names) {
            EXPECT_TRUE(names.insert(name).second) << name;
            EXPECT_THAT(text, HasSubstr("`" + name + "`"));
        }
    }
}

TEST(TruthChannels, AreWrittenWhereTheirExtraWasAskedForAndNowhereElse) {
    const Scene scene = load_scene("sphere");
    const CameraFrame frame(scene.views.at(0).camera, 24, 16);
    for (const auto extra :
         {&TruthExtras::causes, &TruthExtras::one_layer_bound, &TruthExtras::bent_normals}) {
        TruthSettings settings;
        settings.samples = 8;
        settings.extras.*extra = true;
        const Truth truth =
            ReferenceScene(scene).trace(frame, {{Falloff::binary, 1, 0}}, settings, "channels");
        const std::filesystem::path path = output_dir() / "truth.exr";
        write_truth(path, truth, truth.hits.surface, {});
        const ImageFile file = read_image(path);
        for (const TruthChannel& channel : truth_channels()) {
            const bool expected = channel.gathered_by == nullptr || channel.gathered_by == extra;
            EXPECT_EQ(channel.held_by(truth), expected) << channel.id;
            for (std::size_t i = 0; i < channel.exr_names.size(); ++i) {
                const ImageF* plane = file.channel(channel.exr_names[i]);
                ASSERT_EQ(plane != nullptr, expected) << channel.exr_names[i];
                if (!expected) continue;
                EXPECT_EQ(plane->pixels, channel.planes(truth)[i].pixels) << channel.exr_names[i];
            }
        }
    }
}

}  // namespace
}  // namespace aoscore::testing
