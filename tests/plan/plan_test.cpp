#include "plan/plan.h"

#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "screen/method/method.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A home folder with experiments of the test's own.
class Plan : public ::testing::Test {
  protected:
    void SetUp() override {
        home_ = testing::output_dir();
        std::filesystem::create_directories(home_ / "reports");
        std::filesystem::create_directory_symlink(data_dir() / "shaders", home_ / "shaders");
        setenv("AOSCORE_DATA", home_.c_str(), 1);
    }
    void TearDown() override { unsetenv("AOSCORE_DATA"); }

    json definition(const std::string& id, const std::string& view) const {
        return {{"id", id},
                {"title", "A table"},
                {"source", {{"author", "A"}, {"title", "T"}, {"year", 2022}}},
                {"hardware", "none"},
                {"scene", "atrium"},
                {"view", view},
                {"size", {64, 48}},
                {"samples", 16},
                {"radius_m", 0.5},
                {"rows", json::array({{{"method", "alchemy"},
                                       {"preset", "quality"},
                                       {"published", {{"ao_ms", 1.1}, {"bias", nullptr}}}}})},
                {"notes", json::array()}};
    }
    void write(const json& definition) {
        std::ofstream(home_ / "reports" / (definition.at("id").get<std::string>() + ".json")) << definition;
    }
    std::string error_of(const std::vector<std::string>& ids, ExitCode expected) {
        try {
            plan_experiments(ids);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), expected) << e.what();
            return e.what();
        }
        ADD_FAILURE() << "no error";
        return "";
    }

    std::filesystem::path home_;
};

TEST_F(Plan, TablesOfOneViewShareItsTraceAndTheirCells) {
    json finer = definition("b", "wide");
    finer["samples"] = 64;
    finer["rows"].push_back({{"method", "hbao"}, {"preset", "quality"}, {"published", json::object()}});
    write(definition("a", "wide"));
    write(finer);
    write(definition("c", "close"));
    const ExperimentPlan plan = plan_experiments({"a", "b", "c"});
    ASSERT_EQ(plan.views.size(), 2u);
    EXPECT_EQ(plan.views[0].samples, 64) << "the finest truth that any table asks for";
    const auto of_tables = [](const CellPlan& cell) { return !cell.step; };
    EXPECT_EQ(std::ranges::count_if(plan.views[0].cells, of_tables), 2)
        << "alchemy is run once for both tables";
    ASSERT_EQ(plan.tables.size(), 3u);
    EXPECT_EQ(plan.tables[1].cell_indices, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(plan.tables[2].view_index, 1u);
}

TEST_F(Plan, AnUnknownReportListsTheKnownOnes) {
    write(definition("known", "wide"));
    EXPECT_THAT(error_of({"unknown"}, ExitCode::usage), HasSubstr("known"));
}

TEST_F(Plan, EveryKeyOfADefinitionMustBeUnderstood) {
    json bad = definition("bad", "wide");
    bad["rows"][0]["presset"] = "quality";
    write(bad);
    EXPECT_THAT(error_of({"bad"}, ExitCode::file_error), HasSubstr("bad.json: rows[0].presset"));
}

TEST_F(Plan, PublishedFiguresAreNumbersOrNull) {
    json bad = definition("bad", "wide");
    bad["rows"][0]["published"]["ao_ms"] = "1.1 ms";
    write(bad);
    EXPECT_THAT(error_of({"bad"}, ExitCode::file_error), HasSubstr("published.ao_ms"));
}

TEST_F(Plan, SizesAndRadiiMustMakeSense) {
    for (const auto& [key, value] : std::vector<std::pair<std::string, json>>{{"radius_m", 0},
                                                                              {"radius_m", -1},
                                                                              {"samples", 0},
                                                                              {"samples", 1.5},
                                                                              {"size", {0, 10}},
                                                                              {"size", {10}},
                                                                              {"size", {10.5, 10}}}) {
        json bad = definition("bad", "wide");
        bad[key] = value;
        write(bad);
        EXPECT_THAT(error_of({"bad"}, ExitCode::file_error), HasSubstr(key)) << value;
    }
}

// This test reads the program's own definitions.
TEST(Experiments, PlanTheClaimsThatTheyName) {
    for (const ExperimentDefinition& experiment : list_experiments()) {
        const json definition = json::parse(read_file(experiment.file));
        const ExperimentPlan plan = plan_experiments({experiment.id}, 0.1);
        EXPECT_EQ(plan.claim_ids, definition.value("claims", std::vector<std::string>{})) << experiment.id;
        EXPECT_FALSE(plan.views.empty()) << experiment.id;
    }
}

TEST(Experiments, HoldEveryLayeredMethodAgainstWhatOneLayerCannotKnow) {
    const std::vector<MethodDescriptor> methods = load_methods();
    std::size_t layered = 0;
    for (const ExperimentDefinition& experiment : list_experiments()) {
        const ExperimentPlan plan = plan_experiments({experiment.id}, 0.1);
        for (const SweepPlan& sweep : plan.sweeps) {
            for (const SweepPoint& point : sweep.points) {
                const ViewPlan& view = plan.views.at(point.view_index);
                const MethodDescriptor& method = find_method(methods, view.cells.at(point.cell_index).method);
                if (!method.depth_layers && !method.side_layers) continue;
                ++layered;
                EXPECT_TRUE(view.extras.one_layer_bound) << experiment.id << " " << view.scene << " " << method.id;
            }
        }
    }
    EXPECT_GT(layered, 100u);
}

TEST(Experiments, TellEverySettingOfAViewFromTheOthers) {
    for (const ExperimentDefinition& experiment : list_experiments()) {
        for (const SweepPlan& sweep : plan_experiments({experiment.id}, 0.1).sweeps) {
            std::set<std::pair<std::size_t, ParameterValues>> settings;
            for (const SweepPoint& point : sweep.points) {
                EXPECT_TRUE(settings.emplace(point.view_index, point.at).second)
                    << experiment.id << ": " << point.at.at("method").text();
            }
        }
    }
}

TEST(Experiments, PrintTimesOfOneSettingEach) {
    const std::filesystem::path home = testing::output_dir(), real = data_dir();
    std::filesystem::create_directories(home / "reports");
    for (const char* folder : {"shaders", "scenes"}) {
        if (!std::filesystem::exists(home / folder))
            std::filesystem::create_directory_symlink(real / folder, home / folder);
    }
    const json definition = json::parse(read_file(real / "reports" / "vermeer-table-9-3.json"));
    setenv("AOSCORE_DATA", home.c_str(), 1);
    for (const json& at : {json{{"method", "sd-hbao"}}, json{{"use", "always"}, {"depth_samples", 3}},
                           json{{"use", "always"}, {"depth_samples", 2}}}) {
        json changed = definition;
        changed["claims"] = json::array();
        changed["views"][0]["printed"][0]["at"] = at;
        std::ofstream(home / "reports" / "vermeer-table-9-3.json") << changed;
        const bool one = at.value("depth_samples", 0) == 2;
        try {
            plan_experiments({"vermeer-table-9-3"});
            EXPECT_TRUE(one) << at;
        } catch (const Error& e) {
            EXPECT_FALSE(one) << e.what();
            EXPECT_THAT(e.what(), HasSubstr("views[0].printed[0].at"));
        }
    }
    unsetenv("AOSCORE_DATA");
}

}  // namespace
}  // namespace aoscore
