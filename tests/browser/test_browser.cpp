#include "browser/browser_support.h"
#include "core/files.h"
#include "page/page.h"
#include "page/synthetic_results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

/// The page in headless Chromium, driven by playwright-core: each specs/*.spec.mjs begins with its claim.
/// Screenshots stay in the test's output folder. A machine without Chromium, Node or the npm packages skips
/// these tests and says so; with CI=true they fail there.
namespace aoscore {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> specs() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(AOSCORE_BROWSER_SPECS)) {
        const std::string name = entry.path().filename().string();
        const std::size_t at = name.find(".spec.mjs");
        if (at != std::string::npos) names.push_back(name.substr(0, at));
    }
    std::sort(names.begin(), names.end());
    return names;
}

class BrowserSpec : public ::testing::TestWithParam<std::string> {};

TEST_P(BrowserSpec, Holds) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        "score atrium --methods alchemy,hbao,ssao --size 160x96 --samples 64 --quiet --out measured", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path measured = folder / "measured", synthetic = folder / "synthetic";
    write_atomically(folder / "values.json", testing::exr_values(read_results(measured), measured).dump());
    testing::write_synthetic(testing::synthetic_results(), synthetic);
    write_page(synthetic);
    testing::expect_spec_holds(GetParam() + ".spec.mjs", folder);
}

INSTANTIATE_TEST_SUITE_P(Page, BrowserSpec, ::testing::ValuesIn(specs()), [](const auto& name) {
    std::string text = name.param;
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
});

}  // namespace
}  // namespace aoscore
