#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The command fails by itself where a specialised shader and its uniform form give different pictures.
TEST(BenchMethods, ShowsEachPresetBesideItsUniformFormAndSumsUpTheMethodsWithKernels) {
    const std::filesystem::path file = testing::output_dir() / "bench.json";
    const auto run = testing::run_aoscore(
        "bench methods plane --methods ssao,line-sweep,sao --json " + file.string(), testing::output_dir());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const char* row : {"ssao/default", "ssao/samples-42", "sao/default"})
        EXPECT_THAT(run.out, HasSubstr(row));
    EXPECT_THAT(run.out, Not(HasSubstr("line-sweep"))) << "has no shader";
    EXPECT_THAT(run.out, HasSubstr("median over the 1 method with a kernel table"));
    EXPECT_THAT(run.out, HasSubstr("least: "));
    const nlohmann::json written = nlohmann::json::parse(std::ifstream(file));
    EXPECT_EQ(written.at("benchmark"), "methods");
    std::map<std::string, nlohmann::json> rows;
    for (const nlohmann::json& row : written.at("rows")) rows[row.at("name")] = row;
    const nlohmann::json &method = rows.at("sao/default"), &baseline = rows.at(method.at("baseline"));
    EXPECT_TRUE(baseline.at("ratio").is_null());
    EXPECT_EQ(method.at("unit"), baseline.at("unit"));
    EXPECT_DOUBLE_EQ(method.at("ratio"),
                     method.at("value").get<double>() / baseline.at("value").get<double>());
}

}  // namespace
}  // namespace aoscore
