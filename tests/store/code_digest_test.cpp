// The build takes the code of each kind of artifact from the linker, and leaves the list beside the digests.
#include "store/code_digest.h"

#include "core/error.h"
#include "core/files.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::Not;

std::set<std::string> code_of(const std::string& kind) {
    const fs::path list = fs::path(testing::program()).parent_path().parent_path() / "code" / (kind + ".txt");
    std::istringstream lines(read_file(list));
    std::set<std::string> files;
    for (std::string line; std::getline(lines, line);) files.insert(line);
    return files;
}

TEST(CodeDigest, CoversEveryFileThatDecidesANumber) {
    EXPECT_THAT(code_of("truth"), Contains("reference/estimate/estimate.cpp"));
    EXPECT_THAT(code_of("truth"), Contains("core/sampling.h"));
    EXPECT_THAT(code_of("image"), Contains("screen/method/kernel.cpp"));
    EXPECT_THAT(code_of("contract"), Contains("jobs/camera_contract.cpp"));
    EXPECT_THAT(code_of("contract"), Contains("jobs/pixel_facts.cpp"));
    EXPECT_THAT(code_of("view"), Contains("jobs/truth_record.cpp"));
    EXPECT_THAT(code_of("files"), Contains("jobs/image_output.cpp"));
    EXPECT_THAT(code_of("image"), Contains("jobs/masked_mean.h"));
    EXPECT_THAT(code_of("score"), Contains("metrics/measures/rmse.cpp"));
    EXPECT_THAT(code_of("score"), Contains("metrics/intervals/bootstrap.cpp"));
    EXPECT_THAT(code_of("times"), Contains("jobs/timing.cpp"));
    EXPECT_THAT(code_of("stress"), Contains("stress/stress_judge.cpp"));
    EXPECT_THAT(code_of("truth_image"), Contains("jobs/contest/truth_image.cpp"));
    EXPECT_THAT(code_of("views"), Contains("framing/outline_fit.cpp"));
}

TEST(CodeDigest, LeavesOutWhatDecidesNone) {
    for (const char* kind : {"truth", "image", "contract", "score", "times"}) {
        for (const std::string& file : code_of(kind)) {
            EXPECT_THAT(file, Not(::testing::HasSubstr("export/"))) << kind;
            EXPECT_THAT(file, Not(::testing::StartsWith("page/"))) << kind;
            EXPECT_THAT(file, Not(::testing::StartsWith("cli/"))) << kind;
            EXPECT_THAT(file, Not(::testing::StartsWith("plan/"))) << kind;
            EXPECT_THAT(file, Not(::testing::HasSubstr("builtin"))) << kind;
        }
    }
    EXPECT_THAT(code_of("score"), Not(Contains("screen/method/kernel.cpp")));
    EXPECT_THAT(code_of("score"), Not(Contains("reference/estimate/estimate.cpp")));
    EXPECT_THAT(code_of("image"), Not(Contains("metrics/measures/rmse.cpp")));
}

TEST(CodeDigest, DiffersByKindAndKnowsNoOther) {
    EXPECT_NE(code_digest("truth"), code_digest("image"));
    EXPECT_EQ(code_digest("truth").size(), 32u);
    EXPECT_THROW(code_digest("nonsense"), Error);
}

}  // namespace
}  // namespace aoscore
