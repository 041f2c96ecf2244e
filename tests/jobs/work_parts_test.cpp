// Tests how the jobs of a command become parts for many processes.
#include "jobs/work_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace aoscore {
namespace {

using nlohmann::json;

json job(const std::string& key, const std::string& kind, const std::string& unit, double cost_s,
         const json& known = false) {
    return {{"key", key},     {"kind", kind}, {"about", unit},   {"asked", kind != "truth"},
            {"known", known}, {"unit", unit}, {"cost_s", cost_s}};
}

/// A view with a truth and so many cells, each an image and a score.
json view_of(std::size_t cells, bool known = false) {
    json jobs = {job("t", "truth", "view", 50, nullptr), job("v", "view", "view", 1, known)};
    for (std::size_t i = 0; i < cells; ++i) {
        const std::string cell = "cell" + std::to_string(i);
        jobs.push_back(job("i" + cell, "image", cell, 1, known));
        jobs.push_back(job("s" + cell, "score", cell, 2, known));
    }
    return {{"jobs", jobs}};
}

TEST(Parts, HoldEveryJobThatIsAskedForOnceAndACellsJobsTogether) {
    for (const std::size_t count : {1u, 2u, 5u, 9u}) {
        const std::vector<WorkPart> parts = even_parts(view_of(8), count);
        EXPECT_EQ(parts.size(), count);
        std::multiset<std::string> keys;
        for (const WorkPart& part : parts) {
            keys.insert(part.keys.begin(), part.keys.end());
            for (const std::string& key : part.keys) {
                if (key[0] != 's') continue;
                EXPECT_EQ(std::ranges::count(part.keys, "i" + key.substr(1)), 1) << key;
            }
        }
        EXPECT_EQ(keys.size(), 17u);
        EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), 17u);
    }
}

TEST(Parts, BeyondTheUnitsHelpToTraceTheTruth) {
    const std::vector<WorkPart> parts = even_parts(view_of(1), 6);
    ASSERT_EQ(parts.size(), 6u);
    for (std::size_t i = 2; i < parts.size(); ++i)
        EXPECT_EQ(parts[i].keys, std::vector<std::string>{"t"}) << i;
}

TEST(Parts, AreNoneWhereEverythingIsKnown) {
    EXPECT_TRUE(even_parts(view_of(3, true), 4).empty());
}

}  // namespace
}  // namespace aoscore
