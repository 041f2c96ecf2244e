#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace aoscore::testing {

/// Names a program or npm package that specs need and that is missing; empty when all are here.
std::string missing_for_browser();

/// The values of the results' EXR files, by the names that the page gives its images: {file, width, height}
/// of raw float32 files that this writes below the folder.
nlohmann::json exr_values(const Results& results, const std::filesystem::path& folder);

/// Runs a script of specs/ with Node, with `folder` as AOSCORE_TEST_FOLDER, and expects that it succeeds.
void expect_spec_holds(const std::string& script, const std::filesystem::path& folder);

}  // namespace aoscore::testing

/// Skips the test on a machine without Chromium, Node or the npm packages, and says so; with CI=true it fails
/// there.
#define REQUIRE_BROWSER()                                                                        \
    if (const std::string missing = aoscore::testing::missing_for_browser(); !missing.empty()) { \
        const char* ci = std::getenv("CI");                                                      \
        if (ci != nullptr && std::string(ci) == "true") FAIL() << missing << " is not there";    \
        GTEST_SKIP() << missing << " is not there";                                              \
    }                                                                                            \
    static_assert(true)
