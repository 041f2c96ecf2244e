#include "core/error.h"
#include "core/files.h"
#include "hand_made.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>

namespace aoscore::testing {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

// A small method of two text files, in a folder outside of the program's own.
constexpr const char* kDescriptor = R"({
  "label": "Depth edges",
  "paper": "none",
  "summary": "Closed where the pixel to the right is nearer by more than `step`",
  "parameters": {"step": {"type": "real", "default": 0.1, "range": [0, 10], "unit": "m", "meaning": "least step", "length_power": 1}},
  "presets": {"coarse": {"step": 1.0}},
  "reference_radius": 0.5,
  "passes": [{"fragment": "edges.frag", "inputs": ["linear_depth"]}]
})";
constexpr const char* kFragment = R"(
#include "contract/ao_pass.glsl"

float visibility(vec2 image_px, vec3 position) {
    float right = tap_linear_depth(image_px + vec2(1.0, 0.0));
    return -position.z - right > p_step ? 0.0 : 1.0;
}
)";

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// Makes a folder of methods that holds this one.
fs::path folder_with(const std::string& descriptor, const std::string& fragment) {
    const fs::path folder = output_dir();
    write(folder / "depth-edges" / "method.json", descriptor);
    write(folder / "depth-edges" / "edges.frag", fragment);
    return folder;
}

std::string error_of(const std::function<void()>& action, ExitCode expected) {
    try {
        action();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), expected) << e.what();
        return e.what();
    }
    return "(no error)";
}

std::string loading_error(const std::string& descriptor, const std::string& fragment = kFragment) {
    const fs::path folder = folder_with(descriptor, fragment);
    return error_of([&] { load_methods(folder); }, ExitCode::file_error);
}

std::string running_error(const std::string& descriptor, const std::string& fragment, ExitCode expected) {
    const auto methods = load_methods(folder_with(descriptor, fragment));
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 32, 18), gbuffer_inputs());
    return error_of([&] { renderer.run(request_for(find_method(methods, "depth-edges"), {}, "default")); },
                    expected);
}

TEST(UsersMethod, OfTwoTextFilesAppearsAndRuns) {
    const auto methods = load_methods(folder_with(kDescriptor, kFragment));
    EXPECT_EQ(methods.size(), load_methods().size() + 1);
    const MethodDescriptor& method = find_method(methods, "depth-edges");
    EXPECT_EQ(method.values("coarse").at("step"), 1.0);
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 160, 90), {});
    const GBufferImages images = renderer.read_gbuffer();
    const ImageF result = renderer.run(request_for(method, {}, "default")).raw;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 159; ++x) {
            if (images.surface.at(x, y) == 0) continue;
            const bool edge = images.linear_depth().at(x, y) - images.linear_depth().at(x + 1, y) > 0.1F;
            ASSERT_EQ(result.at(x, y), edge ? 0.0F : 1.0F);
        }
    }
}

// Follows the walk-through of shaders/README.md: copy a method, change its function.
TEST(UsersMethod, CopiedFromAnExistingOneAndChangedRuns) {
    const fs::path folder = output_dir();
    fs::copy(find_method(load_methods(), "crytek-ssao").folder, folder / "my-ssao",
             fs::copy_options::recursive);
    const auto copied = load_methods(folder);
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 160, 90), gbuffer_inputs());
    const auto filters = load_filters();
    const auto run = [&](const std::vector<MethodDescriptor>& methods, const char* id) {
        return renderer.run(request_for(find_method(methods, id), filters, "default")).raw.pixels;
    };
    EXPECT_EQ(run(copied, "my-ssao"), run(copied, "crytek-ssao"));

    const fs::path fragment = folder / "my-ssao" / "ao.frag";
    write(fragment, replaced(read_file(fragment), "return 1.0 - occlusion", "return 1.0 - 0.5 * occlusion"));
    const auto changed = run(load_methods(folder), "my-ssao");
    const auto original = run(copied, "crytek-ssao");
    for (std::size_t i = 0; i < changed.size(); ++i)
        ASSERT_NEAR(1 - changed[i], 0.5F * (1 - original[i]), 1e-6);
}

TEST(UsersMethod, WithAnIdThatExistsIsAnError) {
    const fs::path folder = output_dir();
    write(folder / "hbao" / "method.json", kDescriptor);
    write(folder / "hbao" / "edges.frag", kFragment);
    EXPECT_THAT(error_of([&] { load_methods(folder); }, ExitCode::file_error), HasSubstr("exists twice"));
}

TEST(Descriptor, UnknownKeyIsAnErrorWithItsPlace) {
    const std::string message =
        loading_error(replaced(kDescriptor, "\"meaning\"", "\"menaing\": 1, \"meaning\""));
    EXPECT_THAT(message, HasSubstr("parameters.step.menaing"));
}

TEST(Descriptor, RoleOfABoundIsPartOfItsName) {
    const std::string bound = replaced(kDescriptor, "\"paper\"", "\"role\": \"bound\", \"paper\"");
    const auto methods = load_methods(folder_with(bound, kFragment));
    EXPECT_EQ(find_method(methods, "depth-edges").role, MethodRole::bound);
    EXPECT_EQ(find_method(methods, "depth-edges").shown_label(), "Depth edges (bound)");
    EXPECT_EQ(find_method(methods, "hbao").role, MethodRole::method);
    EXPECT_EQ(find_method(methods, "hbao").shown_label(), "HBAO");
    EXPECT_THAT(loading_error(replaced(bound, "\"bound\"", "\"winner\"")), HasSubstr("method, bound"));
}

TEST(Descriptor, ParameterThatNoPassUsesIsAnError) {
    EXPECT_THAT(loading_error(kDescriptor, replaced(kFragment, "p_step", "0.1 /* p_step */")),
                HasSubstr("p_step"));
}

TEST(Descriptor, DefaultOutOfRangeIsAnError) {
    EXPECT_THAT(loading_error(replaced(kDescriptor, "\"default\": 0.1", "\"default\": 11")),
                HasSubstr("0 to 10"));
}

TEST(Descriptor, PresetOfAnUnknownParameterIsAnError) {
    EXPECT_THAT(loading_error(replaced(kDescriptor, "{\"step\": 1.0}", "{\"stride\": 1.0}")),
                HasSubstr("presets.coarse.stride"));
}

TEST(Descriptor, LengthsWithoutAReferenceRadiusAreAnErrorThatSaysWhatIsMissing) {
    const std::string message = loading_error(replaced(kDescriptor, "\"reference_radius\": 0.5,\n", ""));
    EXPECT_THAT(message, HasSubstr("reference_radius: is missing"));
    EXPECT_THAT(message, HasSubstr("step"));
    EXPECT_THAT(message, HasSubstr("metres"));
}

TEST(Descriptor, ReferenceRadiusThatIsNoLengthIsAnError) {
    for (const char* wrong : {"0", "-1", "\"stride\"", "\"step\"", "true"}) {
        const std::string message = loading_error(replaced(kDescriptor, "\"reference_radius\": 0.5",
                                                           std::string("\"reference_radius\": ") + wrong));
        EXPECT_THAT(message, HasSubstr("reference_radius")) << wrong;  // the step may be 0
        EXPECT_THAT(message, HasSubstr("metres")) << wrong;
    }
    EXPECT_THAT(loading_error(replaced(kDescriptor, ", \"length_power\": 1", "")),
                HasSubstr("no parameter has a length_power"));
}

TEST(Descriptor, AbsolutePresetMustExistAndSayWhy) {
    const auto with = [](const char* absolute) {
        return loading_error(
            replaced(kDescriptor, "\"reference_radius\"",
                     fmt::format("\"absolute_presets\": {}, \"reference_radius\"", absolute)));
    };
    EXPECT_THAT(with("{\"fine\": \"table 1\"}"), HasSubstr("absolute_presets.fine"));
    EXPECT_THAT(with("{\"coarse\": \"\"}"), HasSubstr("absolute_presets.coarse"));
}

std::string with_filters(const std::string& filters) {
    return replaced(kDescriptor, "\"reference_radius\"",
                    fmt::format("\"preset_filters\": {}, \"reference_radius\"", filters));
}

TEST(Descriptor, FilterOfAPresetIsAnIdOrAnIdWithAPresetOfTheFilter) {
    const auto methods = load_methods(folder_with(
        with_filters(R"({"default": "box-4x4", "coarse": {"filter": "filament-blur", "preset": "ultra"}})"),
        kFragment));
    const MethodDescriptor& method = find_method(methods, "depth-edges");
    EXPECT_EQ(method.filter_of("default").filter, "box-4x4");
    EXPECT_EQ(method.filter_of("default").preset, "default");
    const auto filters = load_filters();
    const MethodRequest request = request_for(method, filters, "coarse");
    EXPECT_EQ(request.filter->id, "filament-blur");
    EXPECT_EQ(request.filter_parameters, request.filter->values("ultra"));
    EXPECT_NE(request.filter_parameters, request.filter->values("default"));
}

TEST(Descriptor, FilterOfAPresetInAnotherFormIsAnErrorWithItsPlace) {
    for (const char* wrong : {R"(["box-4x4"])", R"({"filter": "box-4x4"})", R"({"preset": "ultra"})", "3",
                              R"({"filter": "box-4x4", "preset": "default", "size": 5})"}) {
        EXPECT_THAT(loading_error(with_filters(fmt::format(R"({{"coarse": {}}})", wrong))),
                    HasSubstr("preset_filters.coarse"))
            << wrong;
    }
    EXPECT_THAT(loading_error(with_filters(R"({"fine": "box-4x4"})")), HasSubstr("preset_filters.fine"));
}

TEST(Descriptor, FiltersOfAllPresetsExistWithTheNamedPreset) {
    const auto filters = load_filters();
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [preset, own] : method.preset_filters) {
            if (own.filter == "none") continue;
            EXPECT_NO_THROW(find_method(filters, own.filter).values(own.preset))
                << method.id << ", " << preset;
        }
    }
}

std::string with_layers(const std::string& layers, const char* input = "depth_layers",
                        const char* member = "depth_layers") {
    const std::string asked = replaced(kDescriptor, "\"reference_radius\"",
                                       fmt::format("\"{}\": {}, \"reference_radius\"", member, layers));
    return replaced(asked, "[\"linear_depth\"]", fmt::format("[\"linear_depth\", \"{}\"]", input));
}

TEST(Descriptor, DepthLayersAreValuesOrParametersThatTakeNothingElse) {
    for (const auto& [wrong, place] :
         {std::pair(R"({"samples": 17})", "depth_layers.samples"),
          std::pair(R"({"samples": 2.5})", "depth_layers.samples"),
          std::pair(R"({"alpha": 1.5})", "depth_layers.alpha"),
          std::pair(R"({"alpha": "@step"})", "depth_layers.alpha"),  // its range is wider
          std::pair(R"({"alpha": "@stride"})", "depth_layers.alpha"),
          std::pair(R"({"sampling": "dice"})", "depth_layers.sampling"),
          std::pair(R"({"per_sample": 1})", "depth_layers.per_sample"),
          std::pair(R"({"seed": -1})", "depth_layers.seed"),
          std::pair(R"({"reach": -1})", "depth_layers.reach"),
          std::pair(R"({"facing": 1})", "depth_layers.facing"),
          std::pair(R"({"cameras": 1})", "depth_layers.cameras"),
          std::pair(R"({"layers": 2})", "depth_layers.layers")}) {
        EXPECT_THAT(loading_error(with_layers(wrong)), HasSubstr(place)) << wrong;
    }
    EXPECT_THAT(loading_error(with_layers(R"({"sampling": "dice"})")), HasSubstr("stratified"));
}

TEST(Descriptor, SideLayersAreDepthLayersWithPlacesOfCameras) {
    constexpr const char* kMember = "side_layers";
    for (const auto& [wrong, place] :
         {std::pair(R"({"samples": 17})", "side_layers.samples"),
          std::pair(R"({"cameras": 5})", "side_layers.cameras"),
          std::pair(R"({"scale": 0})", "side_layers.scale"),
          std::pair(R"({"right": "far"})", "side_layers.right"),
          std::pair(R"({"aim": -1})", "side_layers.aim"), std::pair(R"({"left": 1})", "side_layers.left")}) {
        EXPECT_THAT(loading_error(with_layers(wrong, kMember, kMember)), HasSubstr(place)) << wrong;
    }
    EXPECT_THAT(loading_error(with_layers("{}", "normal_smooth", kMember)), HasSubstr("no pass lists"));
    EXPECT_THAT(loading_error(replaced(kDescriptor, "[\"linear_depth\"]", "[\"side_layers\"]")),
                HasSubstr("side_layers: is missing"));
}

TEST(Descriptor, DepthLayersAreAskedForWhereAPassListsThemAndNowhereElse) {
    EXPECT_THAT(loading_error(with_layers("{}", "normal_smooth")), HasSubstr("no pass lists"));
    EXPECT_THAT(loading_error(replaced(kDescriptor, "[\"linear_depth\"]", "[\"depth_layers\"]")),
                HasSubstr("depth_layers: is missing"));
}

TEST(Descriptor, UnknownInputIsAnErrorThatListsTheKnownOnes) {
    EXPECT_THAT(loading_error(replaced(kDescriptor, "[\"linear_depth\"]", "[\"depth\"]")),
                HasSubstr("linear_depth"));
}

TEST(Descriptor, MissingFragmentOrIncludeIsAnError) {
    EXPECT_THAT(loading_error(replaced(kDescriptor, "edges.frag", "egdes.frag")), HasSubstr("egdes.frag"));
    EXPECT_THAT(loading_error(kDescriptor, replaced(kFragment, "ao_pass", "no_pass")),
                HasSubstr("edges.frag:2"));
}

TEST(Pass, SamplingAnInputThatIsNotListedIsAnError) {
    const std::string message = running_error(
        kDescriptor, replaced(kFragment, "-position.z", "centre_normal_smooth().z"), ExitCode::file_error);
    EXPECT_THAT(message, HasSubstr("u_normal_smooth"));
}

TEST(Pass, ListingAnInputThatIsNeverSampledIsAnError) {
    const std::string message =
        running_error(replaced(kDescriptor, "[\"linear_depth\"]", "[\"linear_depth\", \"albedo\"]"),
                      kFragment, ExitCode::file_error);
    EXPECT_THAT(message, HasSubstr("albedo"));
}

TEST(Pass, UniformThatNobodyDeclaredIsAnError) {
    const std::string fragment = replaced(replaced(kFragment, "p_step", "p_step + u_mystery"),
                                          "float visibility", "uniform float u_mystery;\nfloat visibility");
    EXPECT_THAT(running_error(kDescriptor, fragment, ExitCode::file_error), HasSubstr("u_mystery"));
}

TEST(Pass, CompileErrorShowsTheNumberedSourceOfItsFile) {
    const std::string message =
        running_error(kDescriptor, replaced(kFragment, "float right", "floot right"), ExitCode::internal);
    EXPECT_THAT(message, HasSubstr("edges.frag:5"));
    EXPECT_THAT(message, HasSubstr("5 |     floot right"));
}

TEST(Pass, ErrorAfterAnIncludeIsCountedInItsOwnFile) {
    const std::string fragment =
        std::string("#include \"lib/constants.glsl\"\n\n") + replaced(kFragment, "p_step ?", "p_stop ?");
    const std::string message = running_error(
        kDescriptor, fragment + "// p_step\nfloat f() { return p_step; }\n", ExitCode::internal);
    EXPECT_THAT(message, HasSubstr("edges.frag:8"));
}

}  // namespace
}  // namespace aoscore::testing
