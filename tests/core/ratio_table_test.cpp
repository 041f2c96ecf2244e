#include "core/ratio_table.h"

#include "core/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aoscore {
namespace {

TEST(RatioTable, RelatesEachRowToItsBaseline) {
    RatioTable table;
    table.add("a pass over memory", 4, "ms");
    table.add("a metric", 10, "ms", "a pass over memory");
    EXPECT_EQ(table.ratio("a metric"), 2.5);
    const nlohmann::json rows = table.json();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(rows[0].at("ratio").is_null());
    EXPECT_TRUE(rows[0].at("baseline").is_null());
    EXPECT_EQ(rows[1].at("baseline"), "a pass over memory");
    EXPECT_EQ(rows[1].at("ratio"), 2.5);
    EXPECT_EQ(rows[1].at("unit"), "ms");
}

TEST(RatioTable, RefusesABaselineThatIsNotThereOrMeasuresSomethingElse) {
    RatioTable table;
    table.add("a pass over memory", 4, "ms");
    EXPECT_THROW(table.add("a metric", 10, "ms", "a pass"), Error);
    EXPECT_THROW(table.add("a metric", 10, "MiB", "a pass over memory"), Error);
    EXPECT_THROW(table.add("a pass over memory", 5, "ms"), Error);
    EXPECT_THROW(table.ratio("a pass over memory"), Error);
}

}  // namespace
}  // namespace aoscore
