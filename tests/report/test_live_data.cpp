#include "core/error.h"
#include "core/files.h"
#include "report/live_data.h"
#include "report/live_packing.h"
#include "report/synthetic_results.h"
#include "results/image_file.h"
#include "results/live_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// What the page holds for its live section. That it unpacks to the same numbers is shown in tests/browser.
namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

json method(const std::string& id, const std::vector<std::string>& inputs) {
    return {{"id", id}, {"label", id}, {"passes", {{{"inputs", inputs}, {"scale", 1}, {"source", 0}}}}};
}

struct LiveFolder {
    fs::path folder = testing::output_dir();
    Results results = testing::synthetic_results();
    json live = {{"contract", json::object()},
                 {"methods", {method("depth-only", {"linear_depth", "noise_4x4", "depth_mips"})}},
                 {"filters", json::array()},
                 {"views", json::object()}};

    LiveFolder() {
        testing::write_synthetic(results, folder);
        for (const ViewRecord& view : results.views) live["views"][view.key] = {{"width", view.width}};
    }
    LiveData read() const {
        write_atomically(folder / kLiveFile, live.dump());
        return read_live_data(results, folder);
    }
};

TEST(LiveData, HoldsWhatMethodsReadOfEachViewAndNoMore) {
    const LiveFolder folder;
    const LiveData data = folder.read();
    EXPECT_EQ(data.missing, "");
    ASSERT_EQ(data.blocks.size(), 2U);
    EXPECT_EQ(data.blocks[0].first, "live atrium/wide linear_depth");
    const json& view = data.index["views"]["atrium/wide"];
    EXPECT_EQ(view["inputs"].size(), 1U);
    EXPECT_EQ(view["inputs"]["linear_depth"]["data"], data.blocks[0].first);
    EXPECT_EQ(view["noise_floor_rmse"], 0.031);
    std::size_t cells = 0;
    for (const CellRecord& cell : folder.results.cells)
        cells += cell.view_key == "atrium/wide" && cell.error.empty();
    EXPECT_EQ(view["cells"].size(), cells);
}

TEST(LiveData, RefusesWhatNoBrowserCanRunAndSaysWhy) {
    LiveFolder folder;
    folder.live["methods"].push_back({{"id", "swept"}, {"label", "Swept"}, {"processor", "line_sweep"}});
    folder.live["methods"].push_back(method("coloured", {"albedo"}));
    const LiveData data = folder.read();
    EXPECT_EQ(data.index["methods"].size(), 1U);
    ASSERT_EQ(data.refused.size(), 2U);
    EXPECT_EQ(data.refused[0].label, "Swept");
    EXPECT_THAT(data.refused[0].reason, HasSubstr("line_sweep"));
    EXPECT_THAT(data.refused[1].reason, HasSubstr("albedo"));
}

TEST(LiveData, SaysWhatIsMissing) {
    LiveFolder folder;
    EXPECT_THAT(read_live_data(folder.results, folder.folder).missing, HasSubstr(kLiveFile));
    folder.results.views[1].gbuffer_file.clear();
    EXPECT_THAT(folder.read().missing, HasSubstr("G-buffer"));
}

void expect_file_error(const LiveFolder& folder) {
    try {
        folder.read();
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
    }
}

TEST(LiveData, RejectsADamagedFileAChannelThatLacksAndAPlaceOutside) {
    LiveFolder folder;
    folder.live["views"].erase("atrium/wide");
    expect_file_error(folder);
    LiveFolder normals;
    normals.live["methods"].push_back(method("normals", {"normal_geometric"}));
    expect_file_error(normals);
    LiveFolder outside;
    outside.results.views[0].gbuffer_file = "../elsewhere.exr";
    expect_file_error(outside);
}

TEST(LivePacking, SpendsLittleOnPlanesAndRepeatsOnItself) {
    ImageF plane(256, 128);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x)
            plane.at(x, y) = 1.0F / (0.5F - 0.001F * static_cast<float>(x) - 0.0005F * static_cast<float>(y));
    }
    const std::string packed = pack_floats(plane);
    EXPECT_EQ(packed, pack_floats(plane));
    EXPECT_LT(packed.size(), plane.size() * sizeof(float) / 2);
    EXPECT_LT(pack_normals(Image<glm::vec3>(256, 128, glm::vec3(0, 0, 1))).size(), 1000U);
}

}  // namespace
}  // namespace aoscore
