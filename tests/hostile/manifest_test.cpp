#include "core/error.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using aoscore::Error;
using aoscore::ExitCode;
using aoscore::Scene;

struct Case {
    std::string file;         // below hostile/
    std::string expectation;  // "ACCEPT", "ACCEPT+WARN", "REJECT", "REJECT or ACCEPT+WARN"
    bool needs_triangles = true;
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << c.file << " " << c.expectation;
}

/// Valid files that the manifest lets a tool refuse (or asks to where it does not know an extension), and
/// that this one reads in full, without a warning.
const std::set<std::string> kReadInFull = {"node_deep_chain_60000.gltf", "ext_quantization_required.gltf",
                                           "ext_gpu_instancing_required.gltf",
                                           // Its errors are those of an animation.
                                           "tinygltf/regression/unassigned-skeleton.gltf"};

std::vector<Case> crafted_cases() {
    std::vector<Case> cases;
    std::ifstream in(aoscore::testing::shared_dir() / "hostile" / "manifest.json");
    if (!in) return cases;
    for (const auto& entry : nlohmann::json::parse(in)) {
        const std::string file = entry[0], expectation = entry[1];
        if (expectation == "(data)") continue;
        cases.push_back({"crafted/" + file, kReadInFull.contains(file) ? "ACCEPT" : expectation});
    }
    return cases;
}

/// Whether the README names the file as refused whatever the validator says; except for assimp/issue_3269,
/// whose sets of texture coordinates are numbered with a gap: every viewer shows it, and a warning names it.
bool named_refusal(const std::string& file) {
    for (const char* part :
         {"assimp/RecursiveNodes", "assimp/IndexOutOfRange", "assimp/BoxWithInfinites", "assimp/MissingBin",
          "tinygltf/BoundsChecking", "tinygltf/issue-416", "validator/node/node_loop", "validator/glb/"}) {
        if (file.starts_with(part)) return true;
    }
    return false;
}

/// The README's table of files by others, with its rule: errors of the validator mean refusing or warning; a
/// clean file loads when it has triangles.
std::vector<Case> third_party_cases() {
    std::vector<Case> cases;
    std::ifstream in(aoscore::testing::shared_dir() / "hostile" / "README.md");
    std::string line;
    bool in_table = false;
    while (std::getline(in, line)) {
        in_table |= line.starts_with("## third_party");
        if (!in_table || !line.starts_with("| `")) continue;
        const std::size_t end = line.find('`', 3);
        const std::string file = line.substr(3, end - 3);
        const bool is_clean = line.substr(end).starts_with("` | clean");
        const bool is_sound = is_clean || kReadInFull.contains(file);
        Case c{"third_party/" + file, is_sound ? "ACCEPT" : "REJECT or ACCEPT+WARN", false};
        if (named_refusal(file)) c.expectation = "REJECT";
        cases.push_back(c);
    }
    return cases;
}

std::string test_name(const ::testing::TestParamInfo<Case>& info) {
    std::string name = info.param.file;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; },
        '_');
    return name;
}

/// Whether a node draws a mesh and every buffer has data.
bool has_triangles(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(in)), {});
    const bool is_glb = content.starts_with("glTF");
    if (is_glb) {
        unsigned length = 0;
        for (std::size_t i = 4; i-- > 0;) length = length * 256 + static_cast<unsigned char>(content[12 + i]);
        content = content.substr(20, length);
    }
    const auto root = nlohmann::json::parse(content, nullptr, false);
    if (!root.is_object()) return false;
    const auto empty = nlohmann::json::array();
    const auto buffers = root.value("buffers", empty), nodes = root.value("nodes", empty);
    return !buffers.empty() && std::all_of(buffers.begin(), buffers.end(), [&](const auto& b) {
        return is_glb || b.contains("uri");
    }) && std::any_of(nodes.begin(), nodes.end(), [](const auto& node) { return node.contains("mesh"); });
}

void expect_one_clear_line(const Error& error, const std::string& file) {
    const std::string message = error.what();
    EXPECT_EQ(error.exit_code(), ExitCode::file_error) << message;
    EXPECT_NE(message.find(fs::path(file).filename().string()), std::string::npos)
        << "does not name the file: " << message;
    EXPECT_LT(message.size(), 700u) << message;
    EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
        return static_cast<unsigned char>(c) < 32;
    })) << message;
}

void expect_sound(const Scene& scene) {
    EXPECT_GT(scene.triangle_count, 0u);
    EXPECT_FALSE(scene.materials.empty());
    EXPECT_EQ(scene.digest.size(), 32u);
    for (const auto& view : scene.views)
        EXPECT_NO_THROW(aoscore::CameraFrame(view.camera, 64, 36)) << view.id;
    for (const auto& mesh : scene.meshes) {
        ASSERT_FALSE(mesh.triangles.empty());
        ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
        ASSERT_TRUE(mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size());
        ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
        const auto& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        for (const auto& t : mesh.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        for (const auto& p : mesh.positions)
            ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        for (const auto& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-4f);
        for (const auto& uv : mesh.texcoords) {
            const float alpha = aoscore::alpha_at(scene, material, uv);
            ASSERT_TRUE(alpha >= 0 && alpha <= 1) << alpha;
        }
    }
    for (const auto& instance : scene.instances)
        ASSERT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size());
}

class HostileFile : public ::testing::TestWithParam<Case> {};

TEST_P(HostileFile, IsTreatedAsItsManifestSays) {
    const Case& c = GetParam();
    const fs::path path = aoscore::testing::shared_dir() / "hostile" / c.file;
    const bool may_refuse =
        c.expectation.starts_with("REJECT") || (!c.needs_triangles && !has_triangles(path));
    const bool may_load = c.expectation != "REJECT";
    try {
        const Scene scene = aoscore::load_scene(path.string());
        EXPECT_TRUE(may_load) << "loads";
        EXPECT_TRUE(c.expectation == "ACCEPT" || !scene.warnings.empty()) << "loads without a warning";
        for (const std::string& warning : scene.warnings)
            EXPECT_EQ(warning.find('\n'), std::string::npos) << warning;
        expect_sound(scene);
    } catch (const Error& error) {
        const bool says_empty = std::string(error.what()).find("no usable geometry") != std::string::npos;
        EXPECT_TRUE(may_refuse || (!c.needs_triangles && says_empty)) << error.what();
        expect_one_clear_line(error, c.file);
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(HostileFile);
INSTANTIATE_TEST_SUITE_P(Crafted, HostileFile, ::testing::ValuesIn(crafted_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(ByOthers, HostileFile, ::testing::ValuesIn(third_party_cases()), test_name);

TEST(HostileFiles, AreThere) {
    REQUIRE_SHARED_INPUTS();
    EXPECT_EQ(crafted_cases().size(), 157u);
    EXPECT_GE(third_party_cases().size(), 230u);
}

}  // namespace
