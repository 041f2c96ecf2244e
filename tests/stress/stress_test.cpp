#include "stress/stress.h"

#include "core/error.h"
#include "core/files.h"
#include "stress/stress_axes.h"
#include "stress/stress_subjects.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace aoscore::testing {
namespace {

namespace fs = std::filesystem;

class EveryAxis : public ::testing::TestWithParam<StressAxis> {};

TEST_P(EveryAxis, HasOneUnstressedSettingThatIsTheBaseCaseBitForBit) {
    const StressAxis& axis = GetParam();
    const auto unstressed = std::count_if(axis.settings.begin(), axis.settings.end(),
                                          [](const StressSetting& s) { return s.unstressed(); });
    ASSERT_EQ(unstressed, 1);
    const auto setting = std::find_if(axis.settings.begin(), axis.settings.end(),
                                      [](const StressSetting& s) { return s.unstressed(); });
    const StressCase base = base_stress_case(64), same = stress_case(*setting, 64);
    EXPECT_EQ(same.scene.digest, base.scene.digest);
    const Camera &a = same.camera, &b = base.camera;
    EXPECT_TRUE(a.position == b.position && a.target == b.target && a.up == b.up);
    EXPECT_TRUE(a.near == b.near && a.far == b.far && a.fovy_rad == b.fovy_rad);
    EXPECT_TRUE(same.modes == base.modes && same.width == base.width && same.height == base.height);
    EXPECT_TRUE(same.length_scale == 1 && same.radius_scale == 1 && same.has_truth);
}

TEST_P(EveryAxis, NamesItsSettingsApartAndFitForFiles) {
    std::set<std::string> ids;
    for (const StressSetting& setting : GetParam().settings) {
        EXPECT_TRUE(ids.insert(setting.id).second) << setting.id;
        EXPECT_EQ(setting.id.find_first_of("/ \\"), std::string::npos) << setting.id;
        EXPECT_FALSE(setting.label.empty());
    }
}

TEST_P(EveryAxis, ChangesTheCaseAtEveryOtherSetting) {
    if (GetParam().id == "triangles") return;  // other tests count them, and the finest takes long to make
    const StressCase base = base_stress_case(64);
    for (const StressSetting& setting : GetParam().settings) {
        if (setting.unstressed()) continue;
        const StressCase other = stress_case(setting, 64);
        const Camera &a = other.camera, &b = base.camera;
        const bool same_camera = a.position == b.position && a.target == b.target && a.up == b.up &&
                                 a.near == b.near && a.far == b.far && a.fovy_rad == b.fovy_rad;
        EXPECT_FALSE(same_camera && other.scene.digest == base.scene.digest && other.modes == base.modes &&
                     other.width == base.width && other.height == base.height && other.radius_scale == 1 &&
                     other.length_scale == 1)
            << setting.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryAxis, ::testing::ValuesIn(stress_axes()), [](const auto& tested) {
    std::string name(tested.param.id);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

StressPlan small_plan(std::vector<std::string> methods, std::vector<std::string> axes) {
    StressPlan plan;
    plan.methods = std::move(methods);
    plan.axes = std::move(axes);
    plan.size = 64;
    plan.samples = 4;
    return plan;
}

const StressCell& cell_of(const StressSettingRecord& setting, const std::string& subject) {
    return *std::find_if(setting.cells.begin(), setting.cells.end(),
                         [&](const StressCell& c) { return c.subject == subject; });
}

TEST(Stress, FindsNothingAtUnstressedSettings) {
    StressPlan plan = small_plan({"alchemy", "sao"}, {"depth-format", "scale", "tilt", "radius"});
    plan.ends_only = true;
    for (const StressAxisRecord& axis : run_stress(plan, output_dir()).axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            if (!setting.unstressed) continue;
            for (const StressCell& cell : setting.cells) {
                if (!cell.skipped.empty()) continue;
                EXPECT_EQ(cell.deviation, 0.0) << axis.id << ", " << cell.subject;
                EXPECT_EQ(cell.breaks, "") << axis.id << ", " << cell.subject;
            }
        }
    }
}

// Plants a method that takes the root of its radius in pixels less one, which is NaN where the radius is
// below a pixel.
void plant_broken_method(const fs::path& folder) {
    write_atomically(folder / "planted" / "method.json", R"({"label": "p", "paper": "none", "summary": "p",
        "parameters": {"radius": {"type": "real", "default": 0.5, "range": [1e-9, 1e7], "unit": "m",
                                  "length_power": 1, "meaning": "radius"}},
        "reference_radius": "radius",
        "passes": [{"fragment": "p.frag", "inputs": ["linear_depth"]}],
        "truth": {"falloff": "binary", "radius": "radius"}})");
    write_atomically(folder / "planted" / "p.frag", R"(#include "contract/ao_pass.glsl"
        float visibility(vec2 image_px, vec3 position) {
            float radius_px = p_radius * pixels_per_metre(-position.z);
            return 1.0 - 0.01 * sqrt(radius_px - 1.0) / (1.0 + radius_px);
        })");
}

TEST(Stress, FindsAPlantedDefectWhereItBegins) {
    const fs::path folder = output_dir();
    plant_broken_method(folder / "methods");
    StressPlan plan = small_plan({"planted"}, {"radius"});
    plan.methods_dir = folder / "methods";
    const StressResults results = run_stress(plan, folder / "out");
    // Unstressed, 0.5 m are 2.6 to 10 of 64 pixels; at a quarter, the farthest surface has fewer than one.
    const auto breaks = first_breaks(results.axes[0], "planted");
    ASSERT_GE(breaks.size(), 1U);
    EXPECT_EQ(breaks[0].setting->id, "0.25");
    EXPECT_GT(breaks[0].cell->nonfinite, 0U);
    EXPECT_NE(breaks[0].cell->breaks.find("NaN"), std::string::npos);
    EXPECT_TRUE(first_breaks(results.axes[0], "reference").empty());
}

TEST(Stress, RunsTheLargestPictureInPerformancePresetsAlone) {
    const Registry registry = load_registry();
    const auto& axes = stress_axes();
    const auto sizes = std::find_if(axes.begin(), axes.end(), [](const auto& a) { return a.id == "size"; });
    const StressCase largest = stress_case(sizes->settings.back(), 64);
    EXPECT_EQ(largest.width, 4096);
    std::size_t run = 0;
    for (const StressSubject& subject : stress_subjects(registry, {})) {
        const StressRequest request = stress_request(subject, StressJudgement::error, largest, 1);
        if (!request.contestant) continue;
        ++run;
        EXPECT_TRUE(request.preset.starts_with("performance")) << subject.id;
    }
    EXPECT_GT(run, 0U);
}

/// The files of stressed views' artifacts in the store.
std::set<std::string> kept_files(const fs::path& cache) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(cache))
        if (entry.is_regular_file()) files.insert(entry.path().string());
    return files;
}

// No time is measured twice to the bit, so that an equal time proves that nothing ran.
TEST(Stress, GoesOnWhereItStopped) {
    const fs::path folder = output_dir(), out = folder / "out";
    plant_broken_method(folder / "methods");
    StressPlan plan = small_plan({"planted"}, {"depth-format"});
    plan.methods_dir = folder / "methods";
    plan.ends_only = true;
    plan.cache = folder / "cache";
    const auto time_at = [](const StressResults& results, std::size_t setting, const char* subject) {
        return cell_of(results.axes[0].settings[setting], subject).time_ms;
    };
    const StressResults first = run_stress(plan, out);
    const std::set<std::string> kept = kept_files(plan.cache);

    // As after an interruption, the results are missing, and one cell is not in the store.
    fs::remove_all(out);
    fs::path lost;
    for (const std::string& file : kept) {
        if (file.ends_with(".exr")) lost = file;
    }
    fs::remove(lost);
    fs::remove(fs::path(lost).replace_extension(".json"));
    const StressResults second = run_stress(plan, out);
    EXPECT_EQ(kept_files(plan.cache), kept);
    for (std::size_t i = 0; i < first.axes[0].settings.size(); ++i) {
        for (const StressCell& cell : first.axes[0].settings[i].cells) {
            const StressCell& again = cell_of(second.axes[0].settings[i], cell.subject);
            EXPECT_EQ(cell.time_ms, again.time_ms) << cell.subject << ": times are kept apart from cells";
            EXPECT_EQ(cell.mean, again.mean) << cell.subject;
            EXPECT_EQ(cell.deviation, again.deviation) << cell.subject;
        }
    }

    // An edited shader makes only its own cells run again.
    std::string shader = read_file(folder / "methods/planted/p.frag");
    shader.replace(shader.find("0.01"), 4, "0.02");
    write_atomically(folder / "methods/planted/p.frag", shader);
    const StressResults third = run_stress(plan, out);
    EXPECT_NE(time_at(third, 0, "planted"), time_at(second, 0, "planted"));
    EXPECT_EQ(time_at(third, 0, "reference"), time_at(second, 0, "reference"));
    EXPECT_EQ(time_at(third, 0, "box-4x4"), time_at(second, 0, "box-4x4"));

    // Damaged entries are made again.
    for (const std::string& file : kept_files(plan.cache)) {
        if (file.ends_with(".json")) write_atomically(file, "{");
    }
    const StressResults fourth = run_stress(plan, out);
    EXPECT_NE(time_at(fourth, 0, "reference"), time_at(third, 0, "reference"));
    EXPECT_EQ(cell_of(fourth.axes[0].settings[0], "planted").mean,
              cell_of(third.axes[0].settings[0], "planted").mean);
}

TEST(Stress, RefusesUnknownNamesBeforeItWritesAnything) {
    const fs::path out = output_dir() / "out";
    for (const StressPlan& plan : {small_plan({"no-such-method"}, {}), small_plan({}, {"no-such-axis"})}) {
        try {
            run_stress(plan, out);
            FAIL();
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
        }
    }
    EXPECT_FALSE(fs::exists(out));
}

// A coarse part of the settings must be clean: every method, filter and the reference at the ends of every
// axis.
TEST(Stress, LeavesEveryMethodFiniteAndInRangeAtTheEndsOfEveryAxis) {
    StressPlan plan = small_plan({}, {});
    plan.size = 32;
    plan.ends_only = true;
    for (const StressAxisRecord& axis : run_stress(plan, output_dir()).axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            for (const StressCell& cell : setting.cells) {
                const std::string where = axis.id + " " + setting.id + " " + cell.subject;
                EXPECT_EQ(cell.error, "") << where;
                EXPECT_EQ(cell.nonfinite, 0U) << where;
                EXPECT_EQ(cell.out_of_range, 0U) << where;
                EXPECT_EQ(cell.background, 0U) << where;
            }
        }
    }
}

TEST(Stress, RunsEveryMethodOnPicturesOfOnePixelAndOfOddSizes) {
    const Registry registry = load_registry();
    const auto subjects = stress_subjects(registry, {});
    const auto& axes = stress_axes();
    const auto sizes = std::find_if(axes.begin(), axes.end(), [](const auto& a) { return a.id == "size"; });
    ScreenRenderer renderer;
    renderer.set_scene(base_stress_case(64).scene);
    for (const StressSetting& setting : sizes->settings) {
        const StressCase stress = stress_case(setting, 64);
        if (stress.width * stress.height > 20000) continue;
        renderer.draw_gbuffer(CameraFrame(stress.camera, stress.width, stress.height), gbuffer_inputs());
        for (const StressSubject& subject : subjects) {
            const StressRequest request = stress_request(subject, StressJudgement::error, stress, 1);
            if (!request.contestant || request.contestant->timed_request() == nullptr) continue;
            const MethodOutput output = renderer.run(*request.contestant->timed_request());
            ASSERT_EQ(output.visibility.width, stress.width);
            for (const float v : output.visibility.pixels)
                ASSERT_TRUE(v >= 0 && v <= 1) << subject.id << ", " << setting.id;
        }
    }
}

// Where descriptors say that the occluders are not in one depth layer, the reference's own bound shows it.
TEST(Stress, FindsTheBoundOfOneLayerBrokenWhereMethodsBreakByTheirNature) {
    StressPlan plan = small_plan({"gtao", "monte-carlo-points", "hbao"}, {"tilt", "inside"});
    plan.samples = 16;
    // A power after a filter enlarges deviations that the bound keeps below its limit.
    std::set<std::string> enlarging;
    for (const MethodDescriptor& filter : load_filters()) {
        if (filter.find_parameter("exponent") != nullptr &&
            filter.values("default").at("exponent").number() > 1)
            enlarging.insert(filter.id);
    }
    std::size_t breaking = 0;
    for (const StressAxisRecord& axis : run_stress(plan, output_dir()).axes) {
        for (const StressSettingRecord& setting : axis.settings) {
            for (const StressCell& cell : setting.cells) {
                if (cell.breaks.empty() || cell.subject == "one-layer") continue;
                if (enlarging.contains(cell.subject)) continue;
                ++breaking;
                EXPECT_NE(cell_of(setting, "one-layer").breaks, "")
                    << axis.id << " " << setting.id << " " << cell.subject;
            }
        }
    }
    EXPECT_GT(breaking, 0U);
}

TEST(Stress, StatesReasonsOnlyForAxesThatExist) {
    std::set<std::string> ids;
    for (const StressAxis& axis : stress_axes()) ids.emplace(axis.id);
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [axis, reason] : method.limits)
            EXPECT_TRUE(ids.contains(axis)) << method.id << ": " << axis;
    }
}

}  // namespace
}  // namespace aoscore::testing
