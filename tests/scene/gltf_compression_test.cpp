#include "compressed_files.h"
#include "gltf_file.h"
#include "scene/gltf/colour_filter.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace {

using aoscore::Scene;
using aoscore::testing::add_compressed;
using aoscore::testing::all_corners;
using aoscore::testing::compressed_file;
using aoscore::testing::draco_file;
using aoscore::testing::draco_stream;
using aoscore::testing::encoded_triangles;
using aoscore::testing::encoded_vertices;
using aoscore::testing::GltfFile;
using aoscore::testing::Grid;
using aoscore::testing::grid;
using aoscore::testing::has_warning;
using aoscore::testing::output_dir;
using aoscore::testing::plain_file;
using nlohmann::json;

/// Expects the same triangles in the same order. Their corners may be rotated, as the coding of triangles
/// does.
void expect_within(const Scene& a, const Scene& b, double tolerance) {
    const auto corners_a = all_corners(a), corners_b = all_corners(b);
    ASSERT_EQ(corners_a.size(), corners_b.size());
    for (std::size_t first = 0; first + 2 < corners_a.size(); first += 3) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t turn = 0; turn < 3; ++turn) {
            double most = 0;
            for (std::size_t i = 0; i < 3; ++i)
                most = std::max(most, glm::distance(corners_a[first + i], corners_b[first + (i + turn) % 3]));
            least = std::min(least, most);
        }
        ASSERT_LE(least, tolerance) << first / 3;
    }
}

TEST(GltfMeshopt, BothNamesAndEveryModeGiveTheMeshBitForBit) {
    const Grid g = grid(20);
    const Scene plain = plain_file(g).load(output_dir());
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        for (const char* mode : {"TRIANGLES", "INDICES"}) {
            const Scene scene = compressed_file(g, extension, mode).load(output_dir());
            expect_within(plain, scene, 0);
            EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
        }
    }
}

TEST(GltfMeshopt, ExponentsAreUndoneAndShortIndicesRead) {
    const Grid g = grid(16);
    GltfFile file = compressed_file(g, "EXT_meshopt_compression");
    constexpr int kBits = 15;
    const std::size_t vertices = g.positions.size() / 3;
    std::vector<unsigned char> filtered(g.positions.size() * 4);
    meshopt_encodeFilterExp(filtered.data(), vertices, 12, kBits, g.positions.data());
    const int view =
        add_compressed(file, "EXT_meshopt_compression", encoded_vertices(filtered.data(), vertices, 12), 12,
                       vertices, "ATTRIBUTES", "EXPONENTIAL");
    file.document["accessors"][0]["bufferView"] = view;
    const int indices = add_compressed(file, "EXT_meshopt_compression", encoded_triangles(g), 2,
                                       g.indices.size(), "TRIANGLES");
    file.document["accessors"][1]["bufferView"] = indices;
    file.document["accessors"][1]["componentType"] = 5123;
    // The mantissa has a sign, and that of 1.0 is one half: each coordinate is right to half of 2^-(kBits -
    // 2).
    expect_within(plain_file(g).load(output_dir()), file.load(output_dir()),
                  std::sqrt(3.0) * std::ldexp(1.0, 1 - kBits));
}

TEST(GltfMeshopt, OctahedralNormalsAreUnit) {
    const Grid g = grid(8);
    GltfFile file = compressed_file(g, "EXT_meshopt_compression");
    const std::size_t vertices = g.positions.size() / 3;
    std::vector<float> normals;
    for (std::size_t i = 0; i < vertices; ++i) normals.insert(normals.end(), {0.6f, 0, 0.8f, 0});
    std::vector<unsigned char> filtered(vertices * 4);
    meshopt_encodeFilterOct(filtered.data(), vertices, 4, 8, normals.data());
    const int view =
        add_compressed(file, "EXT_meshopt_compression", encoded_vertices(filtered.data(), vertices, 4), 4,
                       vertices, "ATTRIBUTES", "OCTAHEDRAL");
    file.document["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 4;
    file.document["accessors"].push_back({{"bufferView", view},
                                          {"componentType", 5120},
                                          {"normalized", true},
                                          {"count", vertices},
                                          {"type", "VEC3"}});
    file.document["extensionsUsed"].push_back("KHR_mesh_quantization");
    file.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 2;
    const Scene scene = file.load(output_dir());
    for (const glm::vec3& n : scene.meshes[0].normals)
        EXPECT_LT(glm::distance(n, glm::vec3(0.6f, 0, 0.8f)), 0.02f);
}

TEST(GltfMeshopt, ColoursAreThoseOfTheSpecificationsFormula) {
    // These 8 bits are encoded by hand: Y, Co, Cg of (200, 100, 50) are (112.5, 75, -12.5), here whole
    // numbers.
    std::string bytes = {static_cast<char>(112), static_cast<char>(75), static_cast<char>(-12),
                         static_cast<char>(0x80 | 0x40)};
    aoscore::gltf::decode_colours(bytes, 1);
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    EXPECT_EQ(at(0), 112 + 75 + 12);
    EXPECT_EQ(at(1), 112 - 12);
    EXPECT_EQ(at(2), 112 - 75 + 12);
    EXPECT_EQ(at(3), 0x80);  // 64 of 127: doubled
    // Fully opaque at 4 bits: 7 with the mark above it.
    std::string four_bits = {15, 0, 0, 0x0F};
    aoscore::gltf::decode_colours(four_bits, 1);
    for (const char c : four_bits) EXPECT_EQ(static_cast<unsigned char>(c), 255);
}

TEST(GltfMeshopt, BrokenStreamsAndThoseThatStateMoreThanTheyHoldAreRefused) {
    const Grid g = grid(20);
    const auto refusal = [&](const auto& spoil) {
        GltfFile file = compressed_file(g, "EXT_meshopt_compression");
        spoil(file.document["bufferViews"][0],
              file.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
        return file.refusal(output_dir());
    };
    EXPECT_EQ(refusal([](json&, json&) {}), "");
    EXPECT_NE(refusal([](json&, json& m) { m["byteLength"] = 40; }).find("more than a stream of 40 bytes"),
              std::string::npos);
    EXPECT_NE(refusal([](json&, json& m) { m["byteLength"] = 100; }).find("broken compressed stream"),
              std::string::npos);
    EXPECT_NE(refusal([](json& view, json& m) {
                  m["count"] = std::int64_t{1} << 32;
                  view["byteLength"] = 12 * (std::int64_t{1} << 32);
              }).find("bufferView"),
              std::string::npos);
    EXPECT_NE(refusal([](json& view, json& m) {
                  m["count"] = 80'000;
                  view["byteLength"] = 960'000;
                  m["byteLength"] = 900;
              }).find("more than a stream of 900 bytes can hold"),
              std::string::npos);
    for (const auto& [key, value] :
         std::initializer_list<std::pair<const char*, json>>{{"mode", "TRIANGLE"},
                                                             {"filter", "NOPE"},
                                                             {"byteStride", 6},
                                                             {"count", -1},
                                                             {"buffer", 9},
                                                             {"byteOffset", 1 << 30},
                                                             {"count", 399},
                                                             {"filter", "QUATERNION"}}) {
        EXPECT_NE(refusal([&](json&, json& m) { m[key] = value; }).find("EXT_meshopt_compression"),
                  std::string::npos)
            << key;
    }
}

TEST(GltfMeshopt, ANewerCodingIsNamedAndItsFallbackTakenWhereThereIsOne) {
    const Grid g = grid(20);
    const auto folder = output_dir();
    GltfFile file = compressed_file(g, "KHR_meshopt_compression");
    std::vector<unsigned char> newer = encoded_vertices(g.positions.data(), g.positions.size() / 3, 12);
    newer[0] = 0xA1;
    const int view =
        add_compressed(file, "KHR_meshopt_compression", newer, 12, g.positions.size() / 3, "ATTRIBUTES");
    file.document["accessors"][0]["bufferView"] = view;
    EXPECT_NE(file.refusal(folder).find("newer coding"), std::string::npos);

    std::string bytes(reinterpret_cast<const char*>(g.positions.data()), g.positions.size() * sizeof(float));
    bytes.resize(std::max(bytes.size(), 4 * g.indices.size()));  // the indices' view lies in it too
    std::ofstream(folder / "fallback.bin", std::ios::binary) << bytes;
    file.fallback["uri"] = "fallback.bin";
    file.fallback["byteLength"] = bytes.size();
    const Scene scene = file.load(folder);
    expect_within(plain_file(g).load(folder), scene, 0);
    EXPECT_TRUE(has_warning(scene, "fallback"));
}

TEST(GltfMeshopt, AFallbackThatIsNotNeededNeedNotBeThere) {
    GltfFile file = compressed_file(grid(20), "EXT_meshopt_compression");
    file.fallback["uri"] = "not-there.bin";
    EXPECT_EQ(file.refusal(output_dir()), "");
}

double area_of(const Scene& scene) {
    double area = 0;
    const auto corners = all_corners(scene);
    for (std::size_t i = 0; i < corners.size(); i += 3)
        area += glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i])) / 2;
    return area;
}

TEST(GltfDraco, GivesTheSurfaceWithinItsQuantisationByBothOfItsCodings) {
    const Grid g = grid(20);
    const Scene plain = plain_file(g).load(output_dir());
    for (const bool edgebreaker : {true, false}) {
        const Scene scene =
            draco_file(draco_stream(g, 14, edgebreaker), 400, g.indices.size()).load(output_dir());
        EXPECT_EQ(scene.triangle_count, plain.triangle_count);
        EXPECT_LT(glm::distance(scene.bounds.low, plain.bounds.low), 1.0 / (1 << 13));
        EXPECT_LT(glm::distance(scene.bounds.high, plain.bounds.high), 1.0 / (1 << 13));
        EXPECT_NEAR(area_of(scene), area_of(plain), 1e-4 * area_of(plain));
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    }
}

TEST(GltfDraco, CountsThatAccessorsStateWronglyAreAWarning) {
    const Grid g = grid(6);
    const Scene scene = draco_file(draco_stream(g, 14, true), 7, 3).load(output_dir());
    EXPECT_EQ(scene.triangle_count, g.indices.size() / 3);
    EXPECT_TRUE(has_warning(scene, "another count"));
}

TEST(GltfDraco, BrokenStreamsAndThoseThatStateMoreThanTheyHoldAreRefused) {
    const Grid g = grid(20);
    const std::string stream = draco_stream(g, 14, true);
    const auto refusal = [&](std::string spoilt) {
        return draco_file(spoilt, 400, g.indices.size()).refusal(output_dir());
    };
    EXPECT_EQ(refusal(stream), "");
    EXPECT_NE(refusal(stream.substr(0, stream.size() / 2)).find("broken Draco stream"), std::string::npos);
    EXPECT_NE(refusal("DRACX" + stream.substr(5)).find("is no Draco stream"), std::string::npos);
    // Header and traversal are followed by the number of vertices, then of faces, here 2^31.
    std::string many = stream.substr(0, 12);
    many += std::string("\xFF\xFF\xFF\xFF\x07\xFF\xFF\xFF\xFF\x07", 10) + stream.substr(16);
    EXPECT_NE(refusal(many).find("more than a stream"), std::string::npos) << refusal(many);
    GltfFile other_id = draco_file(stream, 400, g.indices.size());
    other_id.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]
                     ["POSITION"] = 5;
    EXPECT_NE(other_id.refusal(output_dir()).find("no attribute of id 5"), std::string::npos);
}

}  // namespace
