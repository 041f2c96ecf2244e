// Frames without their scene: G-buffers and truths of files, in the layouts of several programs.
#include "core/files.h"
#include "image/frame_layout.h"
#include "image/image_file.h"
#include "metrics/metric.h"
#include "results/results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <list>
#include <sstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScene = "wall --view oblique --size 64x48";
constexpr const char* kMethods = " --methods alchemy,gtao,hbao --out page";
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The numbers that an attribute holds.
std::vector<double> numbers_of(const ImageFile& file, const std::string& attribute) {
    std::istringstream text(file.attributes.at(attribute));
    std::vector<double> numbers;
    for (double number = 0; text >> number;) numbers.push_back(number);
    return numbers;
}

class Frame : public ::testing::Test {
  protected:
    void SetUp() override {
        made("gbuffer " + std::string(kScene) + " --out gbuffer.exr");
        made("reference " + std::string(kScene) + " --samples 8 --out truth.exr");
        frame = read_image(folder / "gbuffer.exr");
        camera = camera_json(nlohmann::json::object());
    }

    void made(const std::string& arguments) const {
        const auto run = run_aoscore(arguments, folder);
        ASSERT_EQ(run.exit_code, 0) << arguments << "\n" << run.err;
    }

    const ImageF& plane(const std::string& name) const { return *frame.channel(name); }

    ImageF changed(const ImageF& image, const std::function<float(float, std::size_t)>& change) const {
        ImageF result = image;
        for (std::size_t i = 0; i < result.size(); ++i) result.pixels[i] = change(result.pixels[i], i);
        return result;
    }

    bool is_surface(std::size_t i) const { return plane("mask.Y").pixels[i] > 0.5F; }

    /// The frame's camera as a camera file has it, with further members.
    nlohmann::json camera_json(const nlohmann::json& more) const {
        // A file has the transpose of the matrix for column vectors.
        const std::vector<double> stored = numbers_of(frame, "worldToCamera");
        std::vector<double> matrix(16);
        for (std::size_t row = 0; row < 4; ++row) {
            for (std::size_t column = 0; column < 4; ++column)
                matrix[4 * row + column] = stored[4 * column + row];
        }
        nlohmann::json json = {{"fovy_deg", std::stod(frame.attributes.at("aoscore:fovy_deg"))},
                               {"near_m", std::stod(frame.attributes.at("aoscore:near_m"))},
                               {"far_m", std::stod(frame.attributes.at("aoscore:far_m"))},
                               {"world_to_camera", matrix}};
        json.update(more);
        return json;
    }

    void write(const std::string& name, const std::vector<std::pair<std::string, ImageF>>& channels) const {
        std::vector<ChannelView> views;
        for (const auto& [channel, image] : channels) views.push_back({channel, &image});
        write_exr(folder / name, views, {});
    }

    /// Scores a frame, and returns its results.
    Results scored(const std::string& options) const {
        const auto run = run_aoscore("score " + options + kMethods, folder);
        EXPECT_EQ(run.exit_code, 0) << options << "\n" << run.err;
        return read_results(folder / "page");
    }

    void expect_refused(const std::string& options, int exit_code, const std::string& message) const {
        const auto run = run_aoscore("score " + options + kMethods, folder);
        EXPECT_EQ(run.exit_code, exit_code) << options << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr(message)) << options;
    }

    const fs::path folder = output_dir();
    ImageFile frame;
    nlohmann::json camera;
};

const CellRecord& cell_of(const Results& results, const std::string& method) {
    return *std::ranges::find_if(results.cells,
                                 [&](const CellRecord& cell) { return cell.method == method; });
}

/// Expects every metric of every method to print alike, or, where `tolerance` is given, to differ by no more.
void expect_same_scores(const Results& results, const Results& expected, double tolerance = 0) {
    ASSERT_EQ(results.cells.size(), expected.cells.size());
    for (const CellRecord& cell : expected.cells) {
        for (const Metric& metric : metrics()) {
            const auto& value = cell.ranked.at(std::string(metric.id)).value;
            const auto& other = cell_of(results, cell.method).ranked.at(std::string(metric.id)).value;
            ASSERT_EQ(value.has_value(), other.has_value()) << cell.method << " " << metric.id;
            if (!value) continue;
            const std::string about = cell.method + " " + std::string(metric.id);
            if (tolerance > 0)
                EXPECT_NEAR(*other, *value, tolerance * std::max(1.0, std::abs(*value))) << about;
            else
                EXPECT_EQ(fmt::format("{:.{}f}", *other, metric.decimals),
                          fmt::format("{:.{}f}", *value, metric.decimals))
                    << about;
        }
    }
}

TEST_F(Frame, ThatThisProgramWroteScoresAsItsSceneToThePrintedDigits) {
    const Results of_scene = scored(std::string(kScene) + " --samples 8");
    const Results of_frame = scored("--gbuffer gbuffer.exr --truth truth.exr");
    expect_same_scores(of_frame, of_scene);
    ASSERT_EQ(of_frame.views.size(), 1U);
    EXPECT_EQ(of_frame.views[0].truth_origin, "given");
    EXPECT_EQ(of_frame.views[0].radius_m, of_scene.views[0].radius_m) << "as the truth's header states it";
    EXPECT_EQ(of_frame.views[0].valid_pixels, of_scene.views[0].valid_pixels);
    EXPECT_NEAR(of_frame.views[0].truths[0].noise_floor_rmse, of_scene.views[0].truths[0].noise_floor_rmse,
                1e-9);
    ASSERT_EQ(of_frame.rankings.size(), 1U);
    EXPECT_EQ(of_frame.rankings[0].metric, of_scene.rankings[0].metric);
    EXPECT_THAT(read_file(folder / "page/index.html"), HasSubstr("a frame without its scene"));
}

TEST_F(Frame, ScoresAlikeInTheLayoutOfEveryProgram) {
    const Results expected = scored("--gbuffer gbuffer.exr --truth truth.exr");
    write_atomically(folder / "camera.json", camera.dump());
    const std::vector<double> matrix = camera.at("world_to_camera");
    glm::dmat3 view_from_world;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            view_from_world[column][row] = matrix[static_cast<std::size_t>(4 * row + column)];
    }
    for (const FrameLayout& layout : frame_layouts()) {
        if (layout.id == "aoscore") continue;
        const bool window = layout.depth_kind == DepthKind::window;
        std::map<std::string, std::vector<std::pair<std::string, ImageF>>> files;
        const auto add = [&](std::string_view name, ImageF image) {
            // A layer of its own becomes a file where the layout's components are R, G and B.
            const auto dot = name.rfind('.');
            const bool apart =
                name.substr(dot) == ".R" || name.substr(dot) == ".G" || name.substr(dot) == ".B";
            files[apart ? "out." + std::string(name.substr(0, dot)) + ".12.exr" : "frame.exr"].emplace_back(
                apart ? name.substr(dot + 1) : "ViewLayer." + std::string(name), std::move(image));
        };
        add(layout.depth.front(), changed(plane(window ? "depth.Z" : "Z"), [&](float value, std::size_t i) {
                return window || is_surface(i) ? value : 1e10F;
            }));
        const auto add_normals = [&](const std::vector<std::string_view>& names, const std::string& ours) {
            if (names.empty()) return;
            const std::string components = names.front().back() == 'R' ? "RGB" : "XYZ";
            for (int axis = 0; axis < 3; ++axis) {
                const ImageF image = changed(plane(ours + ".X"), [&](float, std::size_t i) {
                    glm::dvec3 n(plane(ours + ".X").pixels[i], plane(ours + ".Y").pixels[i],
                                 plane(ours + ".Z").pixels[i]);
                    if (layout.world_normals) n = glm::transpose(view_from_world) * n;
                    if (layout.packed_normals) n = n / 2.0 + 0.5;
                    return static_cast<float>(n[axis]);
                });
                const std::string_view name = names.front();
                add(std::string(name.substr(0, name.size() - 1)) + components[static_cast<std::size_t>(axis)],
                    image);
            }
        };
        add_normals(layout.normal_geometric, "N");
        add_normals(layout.normal_smooth, "Ns");
        std::string names;
        for (const auto& [file, channels] : files) {
            write(file, channels);
            names += (names.empty() ? "" : ",") + file;
        }
        SCOPED_TRACE(layout.id);
        const Results results = scored("--gbuffer " + names + " --camera camera.json --truth truth.exr");
        expect_same_scores(results, expected, 2e-3);
        EXPECT_THAT(results.views[0].view_note, HasSubstr("layout " + std::string(layout.id)));
        EXPECT_TRUE(results.views[0].warnings.empty()) << results.views[0].warnings.front();
    }
}

TEST_F(Frame, ScoresAlikeByEveryKindOfDepthAndUnit) {
    const Results expected = scored("--gbuffer gbuffer.exr --truth truth.exr");
    const double half_height = std::tan(glm::radians(camera.at("fovy_deg").get<double>()) / 2);
    const auto slant = [&](std::size_t i) {
        const double x = (static_cast<double>(i % 64) + 0.5) / 32 - 1,
                     y = 1 - (static_cast<double>(i / 64) + 0.5) / 24;
        return static_cast<float>(glm::length(glm::dvec3(x * half_height * 64 / 48, y * half_height, 1)));
    };
    const std::map<std::string, std::function<float(std::size_t)>> kinds = {
        {"view", [&](std::size_t i) { return plane("Z").pixels[i]; }},
        {"negative-view", [&](std::size_t i) { return -plane("Z").pixels[i]; }},
        {"distance", [&](std::size_t i) { return plane("Z").pixels[i] * slant(i); }},
        {"window", [&](std::size_t i) { return plane("depth.Z").pixels[i]; }},
        {"reversed-window", [&](std::size_t i) { return 1 - plane("depth.Z").pixels[i]; }}};
    std::vector<std::pair<std::string, ImageF>> channels;
    for (const std::string axis : {"X", "Y", "Z"})
        channels.emplace_back("Normal." + axis, plane("Ns." + axis));
    for (const DepthKindName& row : depth_kinds()) {
        SCOPED_TRACE(row.id);
        const auto& value = kinds.at(std::string(row.id));
        const bool window = row.id.ends_with("window");
        const double unit = window ? 1 : 0.01;
        ImageF depth = changed(plane("Z"), [&](float, std::size_t i) {
            if (!is_surface(i)) return window ? value(i) : std::numeric_limits<float>::infinity();
            return static_cast<float>(value(i) / unit);
        });
        auto all = channels;
        all.emplace_back("Depth.Z", std::move(depth));
        write("frame.exr", all);
        write_atomically(
            folder / "camera.json",
            camera_json({{"depth", row.id}, {"unit", window ? "m" : "cm"}, {"normals", "view"}}).dump());
        expect_same_scores(scored("--gbuffer frame.exr --camera camera.json --truth truth.exr"), expected,
                           2e-3);
    }
}

TEST_F(Frame, ScoresAlikeWhereItsDepthBufferHasNoFarPlane) {
    const Results expected = scored("--gbuffer gbuffer.exr --truth truth.exr");
    const double near = 0.05;
    for (const bool reversed : {false, true}) {
        SCOPED_TRACE(reversed);
        std::vector<std::pair<std::string, ImageF>> channels;
        for (const std::string axis : {"X", "Y", "Z"})
            channels.emplace_back("Normal." + axis, plane("Ns." + axis));
        channels.emplace_back("Depth.Z", changed(plane("Z"), [&](float, std::size_t i) {
                                  const double from_far =
                                      is_surface(i) ? near / double{plane("Z").pixels[i]} : 0;
                                  return static_cast<float>(reversed ? from_far : 1 - from_far);
                              }));
        write("frame.exr", channels);
        write_atomically(folder / "camera.json",
                         camera_json({{"depth", reversed ? "reversed-window" : "window"},
                                      {"near_m", near},
                                      {"far_m", "infinite"},
                                      {"normals", "view"}})
                             .dump());
        expect_same_scores(scored("--gbuffer frame.exr --camera camera.json --truth truth.exr"), expected,
                           2e-3);
    }
}

TEST_F(Frame, WhoseNormalsPointTheOtherWayIsToldTheSignsByWhichTheyFit) {
    const Results expected = scored("--gbuffer gbuffer.exr --truth truth.exr");
    for (const auto& signs : {std::array{1, -1, 1}, std::array{1, 1, -1}, std::array{-1, 1, 1}}) {
        std::vector<std::pair<std::string, ImageF>> channels{{"Depth.Z", plane("Z")}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string letter(1, "XYZ"[axis]);
            const auto sign = static_cast<float>(signs[axis]);
            channels.emplace_back(
                "Normal." + letter,
                changed(plane("Ns." + letter), [&](float n, std::size_t) { return sign * n; }));
        }
        write("frame.exr", channels);
        write_atomically(folder / "camera.json", camera_json({{"normals", "view"}}).dump());
        const Results turned = scored("--gbuffer frame.exr --camera camera.json --truth truth.exr");
        const bool first_alone = signs[0] < 0;  // the same as both others, as normals face the camera
        EXPECT_THAT(turned.views[0].warnings,
                    ::testing::Contains(
                        HasSubstr(fmt::format(R"("normal_signs": [1, {}, {}])", first_alone ? -1 : signs[1],
                                              first_alone ? -1 : signs[2]))));
        write_atomically(folder / "camera.json",
                         camera_json({{"normals", "view"}, {"normal_signs", signs}}).dump());
        const Results right = scored("--gbuffer frame.exr --camera camera.json --truth truth.exr");
        EXPECT_TRUE(right.views[0].warnings.empty());
        expect_same_scores(right, expected, 2e-3);
    }
}

// Names alone do not say that this program wrote the file, and turned its normals.
TEST_F(Frame, OfPlainNamesHasItsNormalsReadAsTheCameraFileSaysAndHeldToTheDepth) {
    const Results expected = scored("--gbuffer gbuffer.exr --truth truth.exr");
    EXPECT_TRUE(expected.views[0].warnings.empty());
    const std::vector<double> matrix = camera.at("world_to_camera");
    std::vector<std::pair<std::string, ImageF>> negated{{"Z", plane("Z")}}, in_world = negated;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string name = std::string("N.") + "XYZ"[axis];
        const float sign = axis == 1 ? -1.0F : 1.0F;
        negated.emplace_back(name, changed(plane(name), [&](float n, std::size_t) { return sign * n; }));
        in_world.emplace_back(name, changed(plane(name), [&](float, std::size_t i) {
                                  double sum = 0;  // the transpose turns back from the camera's space
                                  for (std::size_t row = 0; row < 3; ++row)
                                      sum += matrix[4 * row + axis] *
                                             double{plane(std::string("N.") + "XYZ"[row]).pixels[i]};
                                  return static_cast<float>(sum);
                              }));
    }
    write("negated.exr", negated);
    write("world.exr", in_world);
    const auto with_camera = [&](const std::string& file, const nlohmann::json& keys) {
        write_atomically(folder / "camera.json", camera_json(keys).dump());
        return scored("--gbuffer " + file + " --layout aoscore --camera camera.json --truth truth.exr");
    };
    EXPECT_THAT(with_camera("negated.exr", nlohmann::json::object()).views[0].warnings,
                ::testing::Contains(HasSubstr(R"("normal_signs": [1, -1, 1])")));
    const Results signs = with_camera("negated.exr", {{"normal_signs", {1, -1, 1}}});
    EXPECT_THAT(signs.views[0].warnings, ::testing::IsEmpty());
    EXPECT_THAT(signs.views[0].view_note, HasSubstr("layout aoscore"));
    expect_same_scores(signs, expected, 2e-3);
    const Results misread = with_camera("world.exr", {{"normals", "view"}});
    EXPECT_GT(std::abs(*cell_of(misread, "gtao").ranked.at("rmse").value -
                       *cell_of(expected, "gtao").ranked.at("rmse").value),
              0.01);
    std::vector<ChannelView> views;  // as programs leave them that keep the header
    for (const auto& [name, image] : negated) views.push_back({name, &image});
    write_exr(folder / "edited.exr", views, frame.attributes);
    EXPECT_THAT(scored("--gbuffer edited.exr --truth truth.exr").views[0].warnings,
                ::testing::Contains(HasSubstr(R"("normal_signs": [1, -1, 1])")));
    const Results world = with_camera("world.exr", {{"normals", "world"}});
    EXPECT_THAT(world.views[0].warnings, ::testing::IsEmpty());
    expect_same_scores(world, expected, 2e-3);
    EXPECT_THAT(with_camera("gbuffer.exr", {{"normal_signs", {1, -1, 1}}}).views[0].warnings,
                ::testing::Contains(HasSubstr("fit the depth in")));
}

TEST_F(Frame, OfAnotherCodingOfNormalsOrAMirroringCameraIsRefused) {
    std::vector<std::pair<std::string, ImageF>> channels{{"Depth.Z", plane("Z")}};
    const auto octahedral = [&](const std::string& axis) {
        return changed(plane("Ns." + axis), [&](float n, std::size_t i) {
            const float sum = std::abs(plane("Ns.X").pixels[i]) + std::abs(plane("Ns.Y").pixels[i]) +
                              std::abs(plane("Ns.Z").pixels[i]);
            return std::round(127 * n / std::max(sum, 1e-6F)) / 127;
        });
    };
    channels.emplace_back("Normal.X", octahedral("X"));
    channels.emplace_back("Normal.Y", octahedral("Y"));
    write_atomically(folder / "camera.json", camera_json({{"normals", "view"}}).dump());
    write("two.exr", channels);
    expect_refused("--gbuffer two.exr --camera camera.json --truth truth.exr", 4, "octahedral");
    channels.emplace_back("Normal.Z", ImageF(64, 48, 0));
    write("three.exr", channels);
    expect_refused("--gbuffer three.exr --camera camera.json --truth truth.exr", 4, "coded in two");
    nlohmann::json mirroring = camera_json({{"normals", "world"}});
    for (std::size_t i = 8; i < 12; ++i)
        mirroring["world_to_camera"][i] = -mirroring["world_to_camera"][i].get<double>();
    write_atomically(folder / "camera.json", mirroring.dump());
    expect_refused("--gbuffer three.exr --camera camera.json --truth truth.exr", 4, "third row negated");
}

TEST_F(Frame, MayShowBackgroundInMostOfItsPixels) {
    const std::string sphere = "sphere --eye 0,2,30 --target 0,8,0 --fovy 40 --size 64x48";
    made("gbuffer " + sphere + " --out far.exr");
    const ImageF mask = *read_image(folder / "far.exr").channel("mask.Y");
    const auto surfaces = std::ranges::count_if(mask.pixels, [](float value) { return value > 0.5F; });
    ASSERT_GT(surfaces, 0);
    ASSERT_LT(2 * surfaces, static_cast<std::ptrdiff_t>(mask.size()));
    write("plain.exr", {{"AO.R", ImageF(64, 48, 0.5F)}});
    EXPECT_EQ(scored("--gbuffer far.exr --truth plain.exr --radius 2").views[0].valid_pixels,
              static_cast<std::size_t>(surfaces));
}

TEST_F(Frame, WithoutNormalsGetsThemFromDepthAndSaysSo) {
    write("frame.exr", {{"Depth.Z", plane("Z")}});
    write_atomically(folder / "camera.json", camera.dump());
    const Results results = scored("--gbuffer frame.exr --camera camera.json --truth truth.exr");
    EXPECT_THAT(results.views[0].view_note, HasSubstr("normals from depth, since the frame has none"));
    // On plane walls they are the triangles'.
    expect_same_scores(results, scored("--gbuffer gbuffer.exr --truth truth.exr"), 0.02);
}

TEST_F(Frame, WhoseTruthIsRenderedTwiceIsDebiasedByTheDifference) {
    made("--seed 2 reference " + std::string(kScene) + " --samples 8 --out again.exr");
    const Results results = scored("--gbuffer gbuffer.exr --truth truth.exr --truth-again again.exr");
    const ImageF first = *read_image(folder / "truth.exr").channel("Y"),
                 second = *read_image(folder / "again.exr").channel("Y");
    double variance = 0, count = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (!is_surface(i)) continue;
        variance += std::pow((double{first.pixels[i]} - double{second.pixels[i]}) / 2, 2);
        ++count;
    }
    for (const CellRecord& cell : results.cells) {
        const double rmse = *cell.ranked.at("rmse").value, debiased = *cell.ranked.at("rmse_debiased").value;
        EXPECT_NEAR(rmse * rmse - debiased * debiased, variance / count, 1e-6) << cell.method;
    }
}

TEST_F(Frame, WhoseTruthHidesItsErrorIsRankedWithItsNoiseAndSaysSo) {
    write("plain.exr", {{"AO.R", *read_image(folder / "truth.exr").channel("Y")}});
    const Results results = scored("--gbuffer gbuffer.exr --truth plain.exr --radius 0.5");
    EXPECT_FALSE(results.cells[0].ranked.at("rmse_debiased").value);
    EXPECT_EQ(results.rankings.at(0).metric, "rmse");
    EXPECT_EQ(results.views[0].truths[0].se_channel, "");
    EXPECT_THAT(results.views[0].warnings.at(0), HasSubstr("standard error is unknown"));
    expect_refused("--gbuffer gbuffer.exr --truth plain.exr", 64, "at which radius");
    expect_refused("--gbuffer gbuffer.exr --truth truth.exr --radius 77", 64, "the truth was traced at");
}

TEST_F(Frame, RanksTheEnginesOwnImageAmongTheMethods) {
    const Results first = scored("--gbuffer gbuffer.exr --truth truth.exr");
    const CellRecord& method = cell_of(first, "hbao");
    fs::copy_file(folder / "page" / method.image_file, folder / "own.exr");
    const Results results = scored("--gbuffer gbuffer.exr --truth truth.exr --own own.exr --own-channel Y");
    const CellRecord& own = cell_of(results, "own");
    for (const auto& [id, measured] : method.ranked) EXPECT_EQ(own.ranked.at(id).value, measured.value) << id;
    EXPECT_EQ(results.rankings.at(0).places.size(), first.rankings.at(0).places.size() + 1);
}

TEST_F(Frame, LeavesOutMethodsThatNeedMoreAndSaysWhichOnce) {
    const auto run = run_aoscore(
        "score --gbuffer gbuffer.exr --truth truth.exr --methods sd-hbao,hbao --out page", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "page");
    EXPECT_EQ(results.cells.size(), 1U);
    EXPECT_THAT(results.warnings.at(0), HasSubstr("no depth layers, which are drawn from a scene: sd-hbao"));
}

// Neither a run nor its page passes a gate where nothing was scored, and no file of numbers says otherwise.
TEST_F(Frame, ThatNoMethodIsLeftForIsNothingToCompare) {
    for (const char* arguments :
         {"score --gbuffer gbuffer.exr --truth truth.exr --methods sd-hbao --out page",
          "score --gbuffer gbuffer.exr --truth truth.exr --methods sd-hbao --out page --fail 'rmse>0.9' "
          "--export none.xml",
          "page page", "page page --fail 'rmse>0.9' --export none.xml"}) {
        const auto run = run_aoscore(arguments, folder);
        EXPECT_EQ(run.exit_code, 2) << arguments << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr("no method was scored: nothing could be compared")) << arguments;
    }
    EXPECT_FALSE(fs::exists(folder / "none.xml"));
}

TEST_F(Frame, ThatIsMeasuredAgainTakesAllFromTheStore) {
    scored("--gbuffer gbuffer.exr --truth truth.exr");
    const auto again =
        run_aoscore(std::string("score --gbuffer gbuffer.exr --truth truth.exr") + kMethods, folder);
    EXPECT_THAT(again.err, HasSubstr("all measured before"));
    EXPECT_EQ(read_results(folder / "page").views.at(0).truth_origin, "given");
}

TEST_F(Frame, ThatCannotBeReadIsRefusedInWords) {
    const ImageF& depth = plane("Z");
    const auto broken = [&](const std::string& name, const std::function<float(float, std::size_t)>& change) {
        write(name, {{"Depth.Z", changed(depth, change)}});
        return "--gbuffer " + name + " --camera camera.json --truth truth.exr";
    };
    write_atomically(folder / "camera.json", camera.dump());
    expect_refused("--gbuffer gbuffer.exr", 64, "with --truth FILE");
    expect_refused("", 64, "SCENE, or --gbuffer");
    write("plain.exr", {{"Depth.Z", depth}});
    expect_refused("--gbuffer plain.exr --truth truth.exr", 4, "states no projection");
    expect_refused(broken("nan.exr", [](float d, std::size_t i) { return i == 900 ? kNan : d; }), 4,
                   "1 of 3072 depths are NaN");
    expect_refused(broken("signed.exr", [](float d, std::size_t) { return -d; }), 4, "are negative");
    expect_refused(broken("cm.exr", [](float d, std::size_t) { return 1e5F * d; }), 4, "another unit");
    write("colour.exr", {{"R", depth}, {"G", depth}, {"B", depth}});
    expect_refused("--gbuffer colour.exr --camera camera.json --truth truth.exr", 4,
                   "has no depth that a layout");
    expect_refused("--gbuffer gbuffer.exr --truth truth.exr --layout blendr", 64, "did you mean blender?");
    write("small.exr", {{"AO.R", ImageF(32, 24, 1.0F)}});
    expect_refused("--gbuffer gbuffer.exr --truth small.exr --radius 1", 3, "is 32x24, and the frame 64x48");
    write("nanao.exr",
          {{"AO.R", changed(depth, [](float, std::size_t i) { return i == 1500 ? kNan : 0.5F; })}});
    expect_refused("--gbuffer gbuffer.exr --truth nanao.exr --radius 1", 4, "1 pixels of");
    write("normals.exr", {{"Depth.Z", depth},
                          {"Normal.X", plane("N.X")},
                          {"Normal.Y", plane("N.Y")},
                          {"Normal.Z", plane("N.Z")}});
    nlohmann::json bare = camera;
    bare.erase("world_to_camera");
    write_atomically(folder / "bare.json", bare.dump());
    expect_refused("--gbuffer normals.exr --camera bare.json --truth truth.exr", 4, "normals in world space");
    write_atomically(folder / "typo.json", camera_json({{"fovz", 1}}).dump());
    expect_refused("--gbuffer plain.exr --camera typo.json --truth truth.exr", 4, "fovz");
    expect_refused("--gbuffer gbuffer.exr --truth truth.exr --truth-again truth.exr", 4,
                   "is the same picture");
    EXPECT_FALSE(fs::exists(folder / "page"));
}

TEST_F(Frame, WarnsOfNormalsOfAnotherSpaceAndOfARadiusOfAnotherUnit) {
    write("frame.exr", {{"Depth.Z", plane("Z")},
                        {"Normal.X", plane("N.Y")},
                        {"Normal.Y", plane("N.Z")},
                        {"Normal.Z", plane("N.X")}});
    write_atomically(folder / "camera.json", camera_json({{"normals", "view"}}).dump());
    const Results results = scored("--gbuffer frame.exr --camera camera.json --truth truth.exr");
    EXPECT_THAT(results.views[0].warnings.at(0), HasSubstr("fit the depth in"));
    write("plain.exr", {{"AO.R", *read_image(folder / "truth.exr").channel("Y")}});
    const Results tiny = scored("--gbuffer gbuffer.exr --truth plain.exr --radius 0.001");
    EXPECT_THAT(tiny.views[0].warnings, ::testing::Contains(HasSubstr("the depth may be in another unit")));
}

}  // namespace
}  // namespace aoscore
