#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;

/// `aoscore gbuffer` on a crafted file, in a folder of the test.
struct Outcome {
    aoscore::testing::ProgramRun run;
    bool wrote = false;
};
Outcome draw(const std::string& file, const fs::path& folder) {
    const fs::path input = aoscore::testing::shared_dir() / "hostile" / "crafted" / file;
    const fs::path output = folder / (file + ".exr");
    Outcome outcome;
    outcome.run = aoscore::testing::run_aoscore(
        "gbuffer '" + fs::absolute(input).string() + "' --size 32x18 --out '" + output.string() + "'",
        folder);
    outcome.wrote = fs::exists(output);
    return outcome;
}

TEST(Program, RefusesBadFilesWithExitCodeFourOneLineAndNoOutput) {
    REQUIRE_SHARED_INPUTS();
    const fs::path folder = aoscore::testing::output_dir();
    for (const char* file :
         {"glb_empty_file.glb", "json_deep_nesting.gltf", "json_truncated.gltf", "scene_empty_nodes.gltf",
          "mesh_index_oob_by_one.gltf", "acc_count_overflow.gltf", "mesh_nan_all.gltf",
          "node_cycle_self.gltf", "ext_required_unknown.gltf", "buf_path_traversal_exact.gltf",
          "buf_uri_dev_zero.gltf", "no_such_file.glb"}) {
        const Outcome outcome = draw(file, folder);
        EXPECT_EQ(outcome.run.exit_code, 4) << file << ": " << outcome.run.err;
        EXPECT_FALSE(outcome.wrote) << file;
        EXPECT_EQ(outcome.run.out, "") << file;
        EXPECT_NE(outcome.run.err.find(file), std::string::npos) << outcome.run.err;
        EXPECT_EQ(std::count(outcome.run.err.begin(), outcome.run.err.end(), '\n'), 1) << outcome.run.err;
    }
}

TEST(Program, DrawsOddButSoundFiles) {
    REQUIRE_SHARED_INPUTS();
    const fs::path folder = aoscore::testing::output_dir();
    for (const char* file :
         {"00_control_valid.glb", "camera_none.gltf", "camera_inside_cube.gltf", "camera_inside_wall.gltf",
          "camera_zfar_1e30.gltf", "mat_cutoff_gt1.gltf", "mesh_coords_offset_1e7.gltf",
          "mesh_flat_zero_height.gltf", "node_deep_chain_60000.gltf", "node_20000_instances.gltf",
          "mat_mask_png_bomb.gltf"}) {
        const Outcome outcome = draw(file, folder);
        EXPECT_EQ(outcome.run.exit_code, 0) << file << ": " << outcome.run.err;
        EXPECT_TRUE(outcome.wrote) << file;
    }
}

}  // namespace
