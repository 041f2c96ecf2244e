#include "results/baseline_scope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;

TEST(BaselineScope, NamesWhatIsNotComparedWhereTheResultsHoldIt) {
    Results results;
    results.cells.resize(2);
    EXPECT_EQ(baseline_scope(results), "Compared is the error of visibility.");
    results.cells[1].light["rmse.normal"] = {};
    EXPECT_THAT(baseline_scope(results), HasSubstr("those of light are not held"));
    results.cells[0].signals["bent_normal"] = {};
    EXPECT_THAT(baseline_scope(results),
                HasSubstr("those of light and of bent normals and cones are not held"));
    results.cells[1].light.clear();
    EXPECT_THAT(baseline_scope(results), HasSubstr("those of bent normals and cones are not held"));
}

}  // namespace
}  // namespace aoscore
