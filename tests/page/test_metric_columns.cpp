// Every metric, also one added later, is on the page with the words of its row.
#include "metrics/metric.h"
#include "page/section.h"
#include "page/sections/interval_tables.h"
#include "page/sections/ranking_columns.h"
#include "page/synthetic_results.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;

TEST(MetricColumns, OfTheRankingHaveTheRowsWordsAndDigits) {
    const std::vector<RankingColumn> columns = ranking_columns(testing::synthetic_results());
    ASSERT_GE(columns.size(), metrics().size());
    for (std::size_t i = 0; i < metrics().size(); ++i) {
        const Metric& row = metrics()[i];
        EXPECT_EQ(columns[i].id, row.id);
        EXPECT_EQ(columns[i].label, row.label);
        EXPECT_EQ(columns[i].unit, row.unit);
        EXPECT_EQ(columns[i].meaning, row.meaning);
        EXPECT_EQ(columns[i].decimals, row.decimals);
    }
}

TEST(MetricColumns, OfTheIntervalsAreTheSame) {
    const json heads = interval_tables(testing::synthetic_results()).at(0).at("heads");
    for (std::size_t i = 0; i < metrics().size(); ++i) {
        EXPECT_EQ(heads.at(i).at("label"), metrics()[i].label);
        EXPECT_EQ(heads.at(i).at("unit"), metrics()[i].unit);
    }
}

TEST(MetricColumns, AreExplainedWithTheDirectionOfTheRow) {
    const Results results = testing::synthetic_results();
    const Pictures pictures;
    const LiveData live;
    const json rows = section::measurement({results, pictures, live}).at("metrics");
    ASSERT_EQ(rows.size(), metrics().size());
    for (std::size_t i = 0; i < metrics().size(); ++i) {
        const Metric& row = metrics()[i];
        EXPECT_EQ(rows[i].at("label"), row.label);
        EXPECT_EQ(rows[i].at("meaning"), row.meaning);
        EXPECT_EQ(rows[i].at("paper"), row.paper);
        const std::string better = rows[i].at("better");
        EXPECT_TRUE(better.starts_with(row.better == Metric::Better::lower    ? "lower"
                                       : row.better == Metric::Better::higher ? "higher"
                                                                              : "nearer to 0"))
            << row.id << ": " << better;
    }
}

}  // namespace
}  // namespace aoscore
