#include "results/stress_results.h"

#include "core/error.h"
#include "core/files.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <limits>

namespace aoscore {
namespace {

StressSettingRecord setting(const std::string& id, bool unstressed, const std::string& breaks) {
    StressSettingRecord record;
    record.id = record.label = id;
    record.unstressed = unstressed;
    StressCell cell;
    cell.subject = "m";
    cell.breaks = breaks;
    cell.deviation = 0.25;
    record.cells.push_back(cell);
    return record;
}

StressResults results() {
    StressResults all;
    all.program_version = "1";
    all.subjects.push_back({"m", "M", "method", "default", {{"tilt", "because"}}});
    all.axes.push_back(
        {"tilt",
         "Tilt",
         "angle",
         "error",
         0.05,
         {setting("0", false, "NaN"), setting("30", false, "NaN"), setting("45", false, ""),
          setting("60", true, ""), setting("75", false, ""), setting("80", false, "far off")}});
    return all;
}

TEST(StressResultsFile, ComesBackAsItWasWritten) {
    const auto folder = testing::output_dir();
    EXPECT_FALSE(has_stress_results(folder));
    write_stress_results(results(), folder);
    EXPECT_TRUE(has_stress_results(folder));
    const std::string text = read_file(folder / "stress.json");
    const StressResults again = read_stress_results(folder);
    EXPECT_EQ(again.subjects[0].limits.at("tilt"), "because");
    EXPECT_TRUE(again.axes[0].settings[3].unstressed);
    EXPECT_EQ(again.axes[0].settings[5].cells[0].deviation, 0.25);
    EXPECT_EQ(again.axes[0].settings[5].cells[0].rmse, std::nullopt);
    write_stress_results(again, folder);
    EXPECT_EQ(read_file(folder / "stress.json"), text);
}

TEST(StressResultsFile, IsReadStrictly) {
    const auto folder = testing::output_dir();
    write_stress_results(results(), folder);
    const std::string text = read_file(folder / "stress.json");
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>("\"schema_version\": 1", "\"schema_version\": 99"),
          {"\"unstressed\": true", "\"unstressed\": 1"},
          {"\"meaning\"", "\"meanings\""}}) {
        std::string other = text;
        const auto at = other.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write_atomically(folder / "stress.json", other.replace(at, from.size(), to));
        EXPECT_THROW(read_stress_results(folder), Error) << to;
    }
    EXPECT_THROW(read_stress_results(folder / "nowhere"), Error);
}

TEST(StressResultsFile, NeverHoldsANumberThatIsNone) {
    StressResults bad = results();
    bad.axes[0].settings[0].cells[0].deviation = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(write_stress_results(bad, testing::output_dir()), Error);
}

TEST(FirstBreaks, AreTheNearestToTheUnstressedSettingOnEitherSide) {
    const StressResults all = results();
    const auto breaks = first_breaks(all.axes[0], "m");
    ASSERT_EQ(breaks.size(), 2U);
    EXPECT_EQ(breaks[0].setting->id, "30");
    EXPECT_EQ(breaks[1].setting->id, "80");
    EXPECT_TRUE(first_breaks(all.axes[0], "other").empty());
}

}  // namespace
}  // namespace aoscore
