#include "core/error.h"
#include "core/files.h"
#include "scene/scene.h"
#include "support/spoilt.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace {

namespace fs = std::filesystem;

/// A square in each of the formats.
std::string square(const std::string& format) {
    if (format == "obj") {
        return "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl a\n"
               "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\n";
    }
    if (format == "ply") {
        return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
               "z\n"
               "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 "
               "0\n"
               "4 0 1 2 3\n3 0 1 2\n";
    }
    if (format == "stl") {
        return "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
               "endfacet\nendsolid a\n";
    }
    return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
           "GlobalSettings: {\n Version: 1000\n Properties70: {\n"
           "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\n }\n}\n"
           "Objects: {\n Geometry: 1, \"Geometry::a\", \"Mesh\" {\n  Vertices: *12 {\n   a: "
           "0,0,0,1,0,0,1,1,0,0,1,0\n  }\n"
           "  PolygonVertexIndex: *4 {\n   a: 0,1,2,-4\n  }\n }\n Model: 2, \"Model::a\", \"Mesh\" {\n  "
           "Version: 232\n }\n}\n"
           "Connections: {\n C: \"OO\",1,2\n C: \"OO\",2,0\n}\n";
}

class SpoiledFile : public ::testing::TestWithParam<const char*> {};

TEST_P(SpoiledFile, LoadsOrIsRefusedInOneLineButNeverCrashesUs) {
    const fs::path folder = aoscore::testing::output_dir();
    const std::string format = GetParam(), original = square(format);
    std::mt19937 random(21);
    int loaded = 0, refused = 0;
    for (int i = 0; i < 24; ++i) {
        const fs::path file = folder / (std::to_string(i) + "." + format);
        std::ofstream(file, std::ios::binary)
            << (i == 0 ? original : aoscore::testing::spoilt(original, random));
        try {
            const aoscore::Scene scene = aoscore::load_scene(file.string());
            ASSERT_GT(scene.triangle_count, 0u);
            ++loaded;
        } catch (const aoscore::Error& error) {
            ASSERT_EQ(error.exit_code(), aoscore::ExitCode::file_error) << error.what();
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(loaded, 0);
    EXPECT_GT(refused, 5);
}

INSTANTIATE_TEST_SUITE_P(Formats, SpoiledFile, ::testing::Values("obj", "fbx", "ply", "stl"),
                         [](const auto& format) { return std::string(format.param); });

}  // namespace
