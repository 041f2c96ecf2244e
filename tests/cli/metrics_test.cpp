// Every metric, also one added later, is listed, measured between two images and can be limited.
#include "image/image_file.h"
#include "metrics/metric.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_aoscore;

TEST(MetricsOfTheTable, AreListedWithTheirMeanings) {
    const auto run = run_aoscore("list metrics", output_dir());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    for (const Metric& row : metrics())
        EXPECT_THAT(run.out, HasSubstr(fmt::format("{:<16} {}: {}", row.id, row.label, row.meaning)));
}

TEST(MetricsOfTheTable, AreComparedAndLimitedByTheirIds) {
    const auto folder = output_dir();
    ImageF truth(32, 32), test(32, 32);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            truth.at(x, y) = static_cast<float>(x) / 40;
            test.at(x, y) = truth.at(x, y) + (x % 2 == 0 ? 0.1F : 0.0F);
        }
    }
    write_exr(folder / "truth.exr", std::vector<ChannelView>{{"Y", &truth}}, {});
    write_exr(folder / "test.exr", std::vector<ChannelView>{{"Y", &test}}, {});
    std::string limits;
    for (const Metric& row : metrics()) limits += fmt::format(" --warn '{}>1e9'", row.id);
    const auto run = run_aoscore("compare truth.exr test.exr" + limits, folder);
    EXPECT_THAT(run.err, Not(HasSubstr("no metric")));
    for (const Metric& row : metrics()) EXPECT_THAT(run.out, HasSubstr(fmt::format("\n{:<16} ", row.id)));
}

}  // namespace
}  // namespace aoscore
