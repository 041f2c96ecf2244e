#include "core/files.h"
#include "results/upgrade/schema_upgrade.h"
#include "support/support.h"
#include "verdict/rankings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;

std::filesystem::path results_of_schema(int schema) {
    return testing::source_dir() / "tests/results/older" / fmt::format("schema-{}", schema);
}

TEST(RankedAnew, OfTheOldestSchemaIsTheOrderThatItStated) {
    const Results read = read_results(results_of_schema(kOldestSchema));
    EXPECT_TRUE(read.rankings.empty());
    const Results results = ranked_anew(read);
    ASSERT_EQ(results.rankings.size(), 1U);
    const json stated =
        json::parse(read_file(results_of_schema(kOldestSchema) / "results.json")).at("rankings").at(0);
    const std::vector<PlaceRecord>& places = results.rankings[0].places;
    ASSERT_EQ(places.size(), stated.at("places").size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(places[i].cell_ids, stated.at("places")[i].at("cell_ids"));
        EXPECT_DOUBLE_EQ(places[i].value, stated.at("places")[i].at("value"));
        EXPECT_TRUE(places[i].rank);
    }
}

// Later programs ranked by today's rules: ranks that are computed from their files alone are theirs.
TEST(RankedAnew, OfLaterSchemasIsTheRankingThatTheyHold) {
    for (int schema = kOldestSchema + 1; schema < Results::kSchemaVersion; ++schema) {
        const Results held = read_results(results_of_schema(schema));
        EXPECT_EQ(ranked_anew(held).rankings.size(), held.rankings.size());
        Results without = held;
        without.rankings.clear();
        const Results anew = ranked_anew(without);
        ASSERT_EQ(anew.rankings.size(), held.rankings.size());
        for (std::size_t i = 0; i < held.rankings.size(); ++i) {
            ASSERT_EQ(anew.rankings[i].places.size(), held.rankings[i].places.size());
            for (std::size_t k = 0; k < held.rankings[i].places.size(); ++k) {
                const PlaceRecord &now = anew.rankings[i].places[k], &then = held.rankings[i].places[k];
                EXPECT_EQ(rank_text(now), rank_text(then)) << "schema " << schema;
                EXPECT_NEAR(now.interval->low, then.interval->low, 1e-9) << "schema " << schema;
                EXPECT_NEAR(now.interval->high, then.interval->high, 1e-9) << "schema " << schema;
            }
        }
    }
}

}  // namespace
}  // namespace aoscore
