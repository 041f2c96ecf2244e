// A published table says whether tuning by eye left much, from paired intervals.
#include "page/section.h"
#include "page/sections/tuned_rows.h"
#include "page/synthetic_results.h"
#include "results/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

TunedRowRecord row(const std::string& verdict, double error, const Interval& change) {
    TunedRowRecord r;
    r.step = {"atrium/wide/a/b", "rmse_debiased", 0.1, {}, {}, {}, {}, {}};
    r.step.steps.push_back({"tuned-preset", "tuned, samples 16", error, change, verdict, {}, {}, 4.0, ""});
    r.tuning = {{"held_out", {{"less_published", -0.02}, {"less_published_95", {-0.03, -0.01}}}}};
    return r;
}

class TunedRows : public ::testing::Test {
  protected:
    Results results = testing::synthetic_results();
    TableRecord& table = results.tables.at(0);
    nlohmann::json model() {
        std::vector<const CellRecord*> cells;
        for (const std::string& id : table.cell_ids) cells.push_back(find_cell(results, id));
        return tuned_rows_model(table, cells);
    }
};

TEST_F(TunedRows, AnswerWithWhatIsSure) {
    table.tuned = {row(StepRecord::kCloser, 0.07, {-0.031, -0.029}),
                   row(StepRecord::kTie, 0.1001, {-0.001, 0.001}),
                   row(StepRecord::kFarther, 0.11, {0.009, 0.011})};
    const std::string answer = model().at("answer").get<std::string>();
    EXPECT_THAT(answer, HasSubstr("Of 3 rows, 1 is closer to the truth"));
    EXPECT_THAT(answer, HasSubstr("0.0300 less error with "));
    EXPECT_THAT(answer, HasSubstr("(30 %), no sure change with "));
    EXPECT_THAT(answer, HasSubstr("0.0100 more error with "));
    const nlohmann::json first = model().at("rows").at(0);
    EXPECT_EQ(first.at("change"), "−0.0300 (−0.0310 to −0.0290)");
    EXPECT_EQ(first.at("left_out"), "−0.0200 (−0.0300 to −0.0100)");
    EXPECT_EQ(first.at("fetches"), "+4.0");
}

TEST_F(TunedRows, SayWhyOneIsMissing) {
    TunedRowRecord none;
    none.step.skipped.push_back({"tuned-preset", "no preset was tuned from default"});
    table.tuned = {none, none, row(StepRecord::kCloser, 0.07, {-0.031, -0.029})};
    EXPECT_EQ(model().at("rows").at(0).at("reason"), "no preset was tuned from default");
    EXPECT_THAT(model().at("answer").get<std::string>(), HasSubstr("Of 1 row, 1 is closer"));
}

TEST_F(TunedRows, AreAbsentInFilesWithoutThem) {
    EXPECT_EQ(model(), false);
    const nlohmann::json written = to_json(results);
    EXPECT_FALSE(written.at("tables").at(0).contains("tuned"));
    EXPECT_TRUE(results_from_json(written, "results.json").tables.at(0).tuned.empty());
    table.tuned = {row(StepRecord::kTie, 0.1, {-0.1, 0.1})};
    const Results again = results_from_json(to_json(results), "results.json");
    EXPECT_EQ(again.tables.at(0).tuned.at(0).step.steps.at(0).what, "tuned, samples 16");
}

}  // namespace
}  // namespace aoscore
