#include "core/error.h"
#include "core/files.h"
#include "results/results.h"
#include "results/upgrade/schema_upgrade.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Results that programs of older schemas wrote, as they wrote them but for spaces: tests/results/older/.
namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::filesystem::path older(int schema) {
    return testing::source_dir() / "tests/results/older" / fmt::format("schema-{}", schema);
}

class OlderSchema : public ::testing::TestWithParam<int> {};

TEST_P(OlderSchema, IsReadWithEveryNumberThatItHolds) {
    const json written = json::parse(read_file(older(GetParam()) / "results.json"));
    ASSERT_EQ(written.at("schema_version"), GetParam());
    const Results results = read_results(older(GetParam()));
    EXPECT_EQ(results.schema_version, GetParam());
    ASSERT_EQ(results.cells.size(), written.at("cells").size());
    ASSERT_GE(results.cells.size(), 2U);
    for (std::size_t i = 0; i < results.cells.size(); ++i) {
        const CellRecord& cell = results.cells[i];
        const json& before = written.at("cells")[i];
        EXPECT_EQ(cell.id, before.at("id"));
        EXPECT_EQ(cell.ao.runs_ms, before.at("ao").at("runs_ms"));
        const char* filter = before.contains("blur") ? "blur" : "filter_pass";
        EXPECT_EQ(cell.filter_pass.runs_ms, before.at(filter).at("runs_ms"));
        for (const auto& [id, metric] : cell.ranked) {
            const json& value = before.at("ranked").at(id).at("value");
            EXPECT_EQ(metric.value ? json(*metric.value) : json(), value) << id;
        }
        EXPECT_EQ(cell.ranked.size(), before.at("ranked").size());
        ASSERT_TRUE(cell.analysis);
        EXPECT_EQ(cell.analysis->blocks.squared_sums, before.at("analysis").at("blocks").at("squared_sums"));
    }
    for (const ViewRecord& view : results.views) {
        for (const TruthRecord& truth : view.truths) EXPECT_GT(truth.samples, 0) << "a truth without rays";
    }
}

TEST_P(OlderSchema, SaysWhatItDoesNot) {
    const Results results = read_results(older(GetParam()));
    ASSERT_FALSE(results.warnings.empty());
    EXPECT_THAT(results.warnings.back(), HasSubstr(fmt::format("schema {}", GetParam())));
    EXPECT_THAT(results.warnings.back(), HasSubstr("do not say: "));
    EXPECT_THAT(results.warnings.back(), HasSubstr(GetParam() < 9    ? "processor times"
                                                   : GetParam() < 10 ? "the size of depth layers"
                                                                     : "the light of an environment"));
}

TEST_P(OlderSchema, IsWrittenAsTheSchemaOfToday) {
    const json anew = to_json(read_results(older(GetParam())));
    EXPECT_EQ(anew.at("schema_version"), Results::kSchemaVersion);
    EXPECT_EQ(to_json(results_from_json(anew, "results.json")), anew);
}

// A member that is damaged is not taken for one that the schema lacks.
TEST_P(OlderSchema, IsReadAsStrictlyAsAnyOther) {
    const json written = json::parse(read_file(older(GetParam()) / "results.json"));
    const auto refused = [](const json& results, const char* why) {
        EXPECT_THROW(results_from_json(results, "results.json"), Error) << why;
    };
    json changed = written;
    changed["cells"][0].erase("method");
    refused(changed, "lacks a member that every schema has");
    changed = written;
    changed["cells"][0]["of_tomorrow"] = 1;
    refused(changed, "has a member that no schema has");
    changed = written;
    changed["cells"] = "none";
    refused(changed, "has a text in place of cells");
    changed = written;
    changed["views"][0] = 3;
    refused(changed, "has a number in place of a view");
}

INSTANTIATE_TEST_SUITE_P(Each, OlderSchema, ::testing::Range(kOldestSchema, Results::kSchemaVersion));

TEST(Schema, OfTomorrowOrOfTheFirstDaysIsRefusedInWords) {
    const auto refusal = [](int schema) -> std::string {
        try {
            results_from_json({{"schema_version", schema}}, "results.json");
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::file_error);
            return e.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refusal(Results::kSchemaVersion + 1), HasSubstr("of a newer version"));
    EXPECT_THAT(refusal(kOldestSchema - 1), HasSubstr("of too old a version"));
    EXPECT_THAT(refusal(-1), HasSubstr(fmt::format("{} to {}", kOldestSchema, Results::kSchemaVersion)));
}

}  // namespace
}  // namespace aoscore
