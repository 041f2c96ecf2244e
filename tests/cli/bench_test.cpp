#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The command fails by itself where a specialised shader and its uniform form give different pictures.
TEST(BenchMethods, ShowsEachPresetBesideItsUniformFormAndSumsUpTheMethodsWithKernels) {
    const auto run =
        testing::run_aoscore("bench methods plane --methods ssao,line-sweep,sao", testing::output_dir());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const char* row : {"ssao/default", "ssao/samples-42", "sao/default"})
        EXPECT_THAT(run.out, HasSubstr(row));
    EXPECT_THAT(run.out, Not(HasSubstr("line-sweep"))) << "has no shader";
    EXPECT_THAT(run.out, HasSubstr("median over the 1 method with a kernel table"));
    EXPECT_THAT(run.out, HasSubstr("least: "));
}

}  // namespace
}  // namespace aoscore
