// Tests methods of a user's folder that ask for too much, or for files outside of it.
#include "core/error.h"
#include "hand_made.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace aoscore::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

constexpr const char* kParameters =
    R"("level": {"type": "real", "default": 0.5, "range": [0, 1], "meaning": "what is returned"})";
constexpr const char* kKernels = "";
constexpr const char* kReturnsLevel = "    return p_level;\n";

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// A method of one pass with these members of its descriptor and this body of visibility().
void write_method(const fs::path& folder, const std::string& body,
                  const std::string& parameters = kParameters, const std::string& kernels = kKernels,
                  const std::string& before = "") {
    write(folder / "method.json", fmt::format(R"({{"label": "Hostile", "paper": "none", "summary": "none",
        "parameters": {{{}}}, "kernels": {{{}}}, "passes": [{{"fragment": "ao.frag", "inputs": ["linear_depth"]}}]}})",
                                              parameters, kernels));
    write(folder / "ao.frag", "#include \"contract/ao_pass.glsl\"\n" + before +
                                  "float visibility(vec2 image_px, vec3 position) {\n" + body + "}\n");
}

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
        return e.what();
    }
    return "(no error)";
}

std::string loading_error(const fs::path& folder) {
    return error_of([&] { load_methods(folder); });
}

/// The error of counting the fetches of the folder's method "hostile".
std::string counting_error(const fs::path& folder) {
    const auto methods = load_methods(folder);
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 32, 18), gbuffer_inputs());
    return error_of(
        [&] { renderer.count_fetches(request_for(find_method(methods, "hostile"), {}, "default")); });
}

TEST(HostileMethod, MayIncludeItsOwnFilesAndTheLibraryAlone) {
    const fs::path folder = output_dir(), secret = folder / "secret.glsl";
    write(secret, "hidden words\n");
    write(folder / "methods" / "hostile" / "inner" / "own.glsl", "const float own = 0.0;\n");
    fs::create_symlink(secret, folder / "methods" / "hostile" / "link.glsl");
    const auto error_with = [&](const std::string& include) {
        write_method(folder / "methods" / "hostile", kReturnsLevel, kParameters, kKernels,
                     "#include \"" + include + "\"\n");
        return loading_error(folder / "methods");
    };
    EXPECT_EQ(error_with("inner/own.glsl"), "(no error)");
    EXPECT_EQ(error_with("lib/constants.glsl"), "(no error)");
    for (const std::string& include : {secret.string(), std::string("../../secret.glsl"),
                                       std::string("link.glsl"), std::string("inner/../../../secret.glsl")}) {
        const std::string error = error_with(include);
        EXPECT_THAT(error, HasSubstr("lies outside")) << include;
        EXPECT_THAT(error, HasSubstr("ao.frag:2")) << include;
        EXPECT_THAT(error, Not(HasSubstr("hidden"))) << include;
    }
}

TEST(HostileMethod, MayHaveNeitherItsPassNorItsDescriptorElsewhere) {
    const fs::path folder = output_dir(), method = folder / "methods" / "hostile";
    write_method(method, kReturnsLevel);
    fs::rename(method / "ao.frag", folder / "ao.frag");
    fs::create_symlink(folder / "ao.frag", method / "ao.frag");
    EXPECT_THAT(loading_error(folder / "methods"), HasSubstr("lies outside"));
    fs::rename(method / "method.json", folder / "method.json");
    fs::create_symlink(folder / "method.json", method / "method.json");
    EXPECT_THAT(loading_error(folder / "methods"), HasSubstr("lies outside"));
}

TEST(HostileMethod, ARangeThatGlslCannotHoldIsAnError) {
    const auto error_with = [](const std::string& type, const std::string& range) {
        const fs::path folder = output_dir();
        write_method(folder / "hostile", "    return float(p_level);\n",
                     R"("level": {"type": ")" + type + R"(", "default": 1, "range": )" + range +
                         R"(, "meaning": "m"})");
        return loading_error(folder);
    };
    EXPECT_EQ(error_with("integer", "[-2147483647, 2147483647]"), "(no error)");
    EXPECT_THAT(error_with("integer", "[1, 18446744073709551616]"), HasSubstr("parameters.level.range"));
    EXPECT_THAT(error_with("real", "[0, 1e39]"), HasSubstr("parameters.level.range"));
    EXPECT_THAT(error_with("real", "[2, 1]"), HasSubstr("parameters.level.range"));
}

TEST(HostileMethod, AKernelOfMorePointsThanUniformsIsAnError) {
    const auto error_with = [](const std::string& highest, const std::string& size) {
        const fs::path folder = output_dir();
        write_method(
            folder / "hostile", "    return k_points[p_count - 1].x;\n",
            R"("count": {"type": "integer", "default": 4, "range": [1, )" + highest + R"(], "meaning": "m"})",
            R"("points": {"size": )" + size + "}");
        return loading_error(folder);
    };
    EXPECT_EQ(error_with("2048", "\"@count\""), "(no error)");
    EXPECT_THAT(error_with("2147483647", "\"@count\""), HasSubstr("kernels.points.size"));
    EXPECT_THAT(error_with("4", "1000000000"), HasSubstr("kernels.points.size"));
    EXPECT_THAT(error_with("4", "4294967297"), HasSubstr("kernels.points.size"));
}

TEST(HostileMethod, OneThatCannotBeLoadedIsLeftOutUnlessItIsAskedFor) {
    const fs::path folder = output_dir();
    write_method(folder / "good", kReturnsLevel);
    write_method(folder / "bad", kReturnsLevel, R"("level": 1e999)");
    write_method(folder / "hbao", kReturnsLevel);
    std::vector<std::string> warnings;
    const auto methods = load_asked_methods(folder, {"good"}, warnings);
    EXPECT_EQ(methods.size(), load_methods().size() + 1);
    find_method(methods, "good");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_THAT(warnings[0], HasSubstr("method bad is left out"));
    EXPECT_THAT(warnings[0], HasSubstr("no double holds"));
    EXPECT_THAT(warnings[1], HasSubstr("exists twice"));
    for (const char* id : {"bad", "hbao"}) {
        EXPECT_THAT(error_of([&] { load_asked_methods(folder, {id}, warnings); }), HasSubstr(id));
    }
}

TEST(HostileMethod, WhoseArrayNeedsAllMemoryIsRefused) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "a sanitizer's address space has no limit";
#endif
    const fs::path folder = output_dir();
    write_method(
        folder / "hostile",
        "    float a[100000000];\n    for (int i = 0; i < 100000000; ++i) a[i] = position.z + float(i);\n"
        "    return p_level + a[int(image_px.x)];\n");
    EXPECT_THAT(counting_error(folder), HasSubstr("memory to compile"));
}

TEST(HostileMethod, WhoseLoopTheRasteriserEndsFails) {
    const auto error_with = [](const std::string& body) {
        const fs::path folder = output_dir();
        write_method(folder / "hostile", body);
        return counting_error(folder);
    };
    EXPECT_EQ(error_with("    float x = 0.0;\n    for (int i = 0; float(i) < 60000.0 - p_level; ++i) x += "
                         "sin(position.z * x);\n"
                         "    return x;\n"),
              "(no error)");
    for (const char* body :
         {"    float x = 0.0;\n    for (int i = 0; float(i) < 70000.0 - p_level; ++i) x += sin(position.z * "
          "x);\n    return x;\n",
          "    float x = 0.0;\n    for (int i = 0; i < 300; ++i)\n        for (int k = 0; float(k) < 300.0 - "
          "p_level; ++k) x += "
          "sin(position.z * x);\n    return x;\n",
          "    float x = position.z - p_level;\n    while (x < 10.0) x = x * 0.5 - 1.0;\n    return x;\n",
          "    float x = p_level;\n    while (true) x = sin(x);\n    return x;\n",
          "    while (p_level < 1.0) {}\n    return 1.0;\n"}) {
        EXPECT_THAT(error_with(body), HasSubstr("loops turn more often")) << body;
    }
}

TEST(HostileMethod, ALineOfAnyLengthOverflowsNoStack) {
    const fs::path folder = output_dir();
    write_method(folder / "hostile", kReturnsLevel, kParameters, kKernels,
                 "#include \"" + std::string(2'000'000, 'a') + "\"\n");
    EXPECT_EQ(loading_error(folder), "(no error)") << "the compiler refuses it where the method is used";
}

}  // namespace
}  // namespace aoscore::testing
