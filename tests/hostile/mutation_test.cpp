#include "core/error.h"
#include "core/files.h"
#include "scene/scene.h"
#include "support/spoilt.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

TEST(MutatedFiles, LoadOrAreRefusedButNeverCrash) {
    REQUIRE_SHARED_INPUTS();
    const fs::path crafted = aoscore::testing::shared_dir() / "hostile" / "crafted";
    const fs::path folder = aoscore::testing::output_dir();
    std::mt19937 random(20);
    int loaded = 0, refused = 0;
    for (const char* seed :
         {"00_control_valid.glb", "00_control_valid.gltf", "sparse_valid.gltf", "mat_blend.gltf",
          "mat_mask_texcoord_nan.gltf", "ext_quantization_required.gltf", "camera_scaled_node.gltf"}) {
        const std::string original = aoscore::read_file(crafted / seed);
        for (int i = 0; i < 1200; ++i) {
            // Each file has a name of its own: a file system may wait for the disk when a file is
            // overwritten.
            const fs::path file = folder / (std::to_string(i) + fs::path(seed).extension().string());
            std::ofstream(file, std::ios::binary) << aoscore::testing::spoilt(original, random);
            try {
                const aoscore::Scene scene = aoscore::load_scene(file.string());
                ASSERT_GT(scene.triangle_count, 0u);
                ++loaded;
            } catch (const aoscore::Error& error) {
                ASSERT_EQ(error.exit_code(), aoscore::ExitCode::file_error) << error.what();
                ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
                ++refused;
            }
            fs::remove(file);
        }
    }
    // Were all mutations harmless or all fatal, this would prove nothing.
    EXPECT_GT(loaded, 100);
    EXPECT_GT(refused, 500);
}

}  // namespace
