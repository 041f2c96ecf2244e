#include "core/files.h"
#include "core/folders.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::size_t folders_in(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        count += entry.is_directory() ? 1 : 0;
    return count;
}

TEST(StressCommand, MakesAPageInWhichEveryCellOpensItsPictures) {
    const auto folder = testing::output_dir();
    const auto run =
        testing::run_aoscore("stress --quick --methods sao --axes depth-format,radius --out out", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "out/index.html\n");
    const std::string html = read_file(folder / "out" / "index.html");
    for (const char* text :
         {"Depth format", "Radius", ">SAO<", "Reference (ray tracer)", "First setting that breaks"})
        EXPECT_THAT(html, HasSubstr(text));
    // There are rows for the reference, its bound, the method and every filter, with two and three settings.
    const std::size_t rows = 3 + folders_in(data_dir() / "shaders" / "filters");
    EXPECT_EQ(count_of(html, "data-at=\"0-") + count_of(html, "data-at=\"1-"), rows * 5);
    EXPECT_EQ(count_of(html, "\"visibility\":\"data:image/png;base64,"), 5U);
    EXPECT_EQ(count_of(html, "\"deviation\":\"data:image/png;base64,"), 5U);
    EXPECT_THAT(html, Not(HasSubstr("http://")));
    EXPECT_THAT(html, Not(HasSubstr("https://")));
    EXPECT_FALSE(std::regex_search(html, std::regex(R"(>\s*-?(nan|inf)\s*<)")));

    // The page is made of the results alone.
    std::filesystem::remove(folder / "out" / "index.html");
    const auto again = testing::run_aoscore("page out", folder);
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(read_file(folder / "out" / "index.html"), html);
}

TEST(StressCommand, RefusesUnknownNamesWithTheKnownOnes) {
    const auto folder = testing::output_dir();
    const auto axis = testing::run_aoscore("stress --axes tlit --out out", folder);
    EXPECT_EQ(axis.exit_code, 64);
    EXPECT_THAT(axis.err, HasSubstr("tilt"));
    const auto method = testing::run_aoscore("stress --methods sa0 --out out", folder);
    EXPECT_EQ(method.exit_code, 64);
    EXPECT_THAT(method.err, HasSubstr("sao"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(StressCommand, IsStoppedByCtrlCAndGoesOn) {
    const auto folder = testing::output_dir();
    const std::string call = "stress --quick --methods sao --axes tilt,radius,scale --out out";
    const auto stopped = testing::run_aoscore(call, folder, "timeout -s INT 0.8");
    if (stopped.exit_code != 0) {
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / "stress.json"));
    }
    const auto done = testing::run_aoscore(call, folder);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / "stress.json"));
}

}  // namespace
}  // namespace aoscore
