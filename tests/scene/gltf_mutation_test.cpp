#include "compressed_files.h"
#include "core/error.h"
#include "core/files.h"
#include "support/spoilt.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace {

namespace fs = std::filesystem;
using aoscore::testing::compressed_file;
using aoscore::testing::draco_file;
using aoscore::testing::draco_stream;
using aoscore::testing::GltfFile;
using aoscore::testing::Grid;
using aoscore::testing::grid;

/// A file of each decoder, with skins, morph targets and instances where it has no codec.
std::vector<std::pair<std::string, GltfFile>> seeds() {
    const Grid g = grid(9);
    std::vector<std::pair<std::string, GltfFile>> all;
    all.emplace_back("triangles", compressed_file(g, "EXT_meshopt_compression"));
    all.emplace_back("indices", compressed_file(g, "KHR_meshopt_compression", "INDICES"));
    all.emplace_back("edgebreaker", draco_file(draco_stream(g, 11, true), 81, g.indices.size()));
    all.emplace_back("sequential", draco_file(draco_stream(g, 11, false), 81, g.indices.size()));
    GltfFile posed;
    const int positions = posed.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = posed.add_accessor<std::uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4);
    const int weights = posed.add_accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4);
    posed.add_mesh({{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                    {"targets", {{{"POSITION", positions}}}}});
    posed.document["meshes"][0]["weights"] = {0.5};
    posed.document["skins"] = {{{"joints", {1, 2}}}};
    posed.add_node({{"mesh", 0}, {"skin", 0}});
    posed.add_node({{"children", {2}}});
    posed.document["nodes"].push_back({{"translation", {0, 2, 0}}});
    posed.add_node({{"mesh", 0},
                    {"extensions",
                     {{"KHR_node_visibility", {{"visible", true}}},
                      {"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", positions}}}}}}}});
    all.emplace_back("posed", posed);
    return all;
}

TEST(GltfMutations, OfStreamsPosesAndInstancesLoadOrAreRefusedButNeverCrash) {
    const fs::path folder = aoscore::testing::output_dir();
    std::mt19937 random(12);
    int loaded = 0, refused = 0;
    for (auto& [name, file] : seeds()) {
        const fs::path text = file.write(folder, name), data = folder / (name + ".bin");
        const std::string json = aoscore::read_file(text), bytes = aoscore::read_file(data);
        for (int i = 0; i < 400; ++i) {
            const bool in_text = i % 4 == 0;
            const std::string bad = aoscore::testing::spoilt(in_text ? json : bytes, random);
            std::ofstream(in_text ? text : data, std::ios::binary) << bad;
            try {
                ASSERT_GT(aoscore::load_scene(text.string()).triangle_count, 0u);
                ++loaded;
            } catch (const aoscore::Error& error) {
                ASSERT_EQ(error.exit_code(), aoscore::ExitCode::file_error) << error.what();
                ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
                ++refused;
            }
            std::ofstream(in_text ? text : data, std::ios::binary) << (in_text ? json : bytes);
        }
    }
    // Were all mutations harmless or all fatal, this would prove nothing.
    EXPECT_GT(loaded, 50);
    EXPECT_GT(refused, 500);
}

}  // namespace
