#include "browser/browser_support.h"
#include "core/files.h"
#include "page/index/index_page.h"
#include "page/index_results.h"
#include "page/page.h"
#include "page/synthetic_results.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

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

/// Results with names that a page must only show: markup, text from right to left, 200 letters without a
/// space.
Results with_odd_names(Results results) {
    const std::array<std::string, 3> names = {
        "</noscript></script><script>document.title = 'owned'</script><img src=x "
        "onerror=alert(1)>\"&{{lead}}",
        "חסימת אור סביבתי", std::string(200, 'N')};
    std::map<std::string, std::string> labels;
    for (CellRecord& cell : results.cells) {
        const std::string& name = names.at(labels.size() % names.size());
        cell.method_label = labels.emplace(cell.method, name).first->second;
        if (!cell.error.empty()) cell.error = names[0];
    }
    for (RankingRecord& ranking : results.rankings) {
        for (PlaceRecord& place : ranking.places) place.method_label = labels.at(place.method);
    }
    results.command = "aoscore score " + names[0];
    return results;
}

/// Results of one method on one view.
Results with_one_method(Results results) {
    results.views.resize(1);
    results.rankings.resize(1);
    PlaceRecord first = results.rankings[0].places.at(0);
    first.rank = RankRange{1, 1};
    first.ties.clear();
    results.rankings[0].places = {first};
    std::erase_if(results.cells, [&](const CellRecord& cell) { return cell.id != first.cell_ids.front(); });
    results.tables.clear();
    results.sweeps.clear();
    results.claims.clear();
    return results;
}

/// Results of a score whose images were not stored.
Results ranking_alone(Results results) {
    results.sweeps.clear();
    results.claims.clear();
    return testing::without_pictures(std::move(results));
}

class BrowserSpec : public ::testing::TestWithParam<std::string> {};

TEST_P(BrowserSpec, Holds) {
    REQUIRE_BROWSER();
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        "score atrium --methods alchemy,hbao,ssao --size 160x96 --samples 64 --quiet --out measured", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path measured = folder / "measured";
    write_atomically(folder / "values.json", testing::exr_values(read_results(measured), measured).dump());
    const Results results = testing::synthetic_results();
    testing::write_synthetic(results, folder / "synthetic");
    testing::write_synthetic(with_odd_names(results), folder / "odd-names");
    testing::write_synthetic(with_one_method(results), folder / "one-method");
    testing::write_synthetic(ranking_alone(results), folder / "no-pictures");
    for (const char* made : {"synthetic", "odd-names", "one-method", "no-pictures"})
        write_page(folder / made);
    write_index_page(testing::synthetic_index(100, 4, 25).contents(), folder / "index", "aoscore index runs",
                     1);
    testing::expect_spec_holds(GetParam() + ".spec.mjs", folder);
}

INSTANTIATE_TEST_SUITE_P(Page, BrowserSpec, ::testing::ValuesIn(specs()), [](const auto& name) {
    std::string text = name.param;
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
});

}  // namespace
}  // namespace aoscore
