#include "core/error.h"
#include "core/files.h"
#include "metrics/metric.h"
#include "page/page.h"
#include "page/section.h"
#include "page/synthetic_results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const Results& results) {
    const std::filesystem::path folder = testing::output_dir();
    testing::write_synthetic(results, folder);
    return read_file(write_page(folder));
}

/// The page's visible text, without pictures, style, script and tags.
std::string visible_text(const std::string& html) {
    std::string text = std::regex_replace(html, std::regex("<style>[^<]*</style>"), "");
    for (std::size_t at = text.find("<script"); at != std::string::npos; at = text.find("<script", at)) {
        text.erase(at, text.find("</script>", at) - at + 9);
    }
    std::string plain;
    bool in_tag = false;
    for (const char c : text) {
        if (c == '<') in_tag = true;
        if (!in_tag) plain += c;
        if (c == '>') {
            in_tag = false;
            plain += ' ';
        }
    }
    return plain;
}

TEST(Page, IsOneFileWithoutReferencesOutsideItself) {
    const std::string html = page_of(testing::synthetic_results());
    EXPECT_THAT(html, Not(HasSubstr("@import")));
    EXPECT_THAT(html, Not(HasSubstr("url(")));
    std::size_t references = 0;
    for (const char* attribute : {" src=\"", " href=\"", " srcset=\"", " data=\"", " action=\""}) {
        const std::string opening = attribute;
        for (std::size_t at = html.find(opening); at != std::string::npos; at = html.find(opening, at + 1)) {
            const std::string target = html.substr(at + opening.size(), 22);
            EXPECT_TRUE(target.starts_with("#") || target.starts_with("data:image/png;base64,")) << target;
            ++references;
        }
    }
    EXPECT_GT(references, 15U);
}

TEST(Page, ShowsEverySectionViewCellAndTable) {
    const Results results = testing::synthetic_results();
    const std::string html = page_of(results);
    std::size_t last = 0;
    for (const Section& section : sections()) {
        // These results have neither; see test_signals.cpp and test_light.cpp.
        if (section.id == "signals" || section.id == "light") continue;
        const std::size_t at = html.find("<section id=\"" + std::string(section.id) + "\"");
        ASSERT_NE(at, std::string::npos) << section.id;
        EXPECT_GT(at, last) << section.id << " is out of order";
        last = at;
    }
    for (const CellRecord& cell : results.cells)
        EXPECT_THAT(html, HasSubstr("<tr data-cell=\"" + cell.id + "\""));
    for (const ViewRecord& view : results.views)
        EXPECT_THAT(html, HasSubstr("asc n-last\" data-view=\"" + view.key + "\""));
    for (const TableRecord& table : results.tables) {
        EXPECT_THAT(html, HasSubstr("id=\"" + table.definition.at("id").get<std::string>() + "\""));
    }
    for (const Metric& metric : metrics()) {
        EXPECT_THAT(html, HasSubstr("<dt>" + std::string(metric.label))) << "not explained";
    }
}

TEST(Page, HoldsEachImageOfACellThatSucceededOnce) {
    const Results results = testing::synthetic_results();
    const std::string html = page_of(results);
    for (const CellRecord& cell : results.cells) {
        for (const std::string kind : {"output", "raw"}) {
            const std::string block = "data-image=\"" + cell.id + " " + kind + "\"";
            const bool expected = cell.error.empty() && (kind != "raw" || cell.filter != "none");
            const std::size_t at = html.find(block);
            EXPECT_EQ(at != std::string::npos, expected) << block;
            if (!expected) continue;
            EXPECT_EQ(html.find(block, at + 1), std::string::npos) << block << " twice";
        }
    }
}

TEST(Page, ShowsAFailedCellAsARowWithItsReason) {
    const std::string html = page_of(testing::synthetic_results());
    const std::string row = "<tr data-cell=\"atrium/close/alchemy/performance-close\" class=\"failed\">";
    const std::size_t at = html.find(row);
    ASSERT_NE(at, std::string::npos);
    EXPECT_THAT(html.substr(at, html.find("</tr>", at) - at), HasSubstr("7 pixels are NaN or infinite"));
    EXPECT_THAT(html, HasSubstr("1 cell failed and is not ranked"));
}

TEST(Page, OfResultsWithoutPicturesStillSaysWhichMethodIsClosest) {
    Results results = testing::without_pictures(testing::synthetic_results());
    results.sweeps.clear();
    results.claims.clear();
    const std::string html = page_of(results);
    EXPECT_THAT(html, HasSubstr("These results have no pictures beside them."));
    EXPECT_THAT(html, HasSubstr("is closest of 6 methods to the ray-traced truth"));
    EXPECT_THAT(html, Not(HasSubstr("class=\"stage\"")));
    for (const CellRecord& cell : results.cells)
        EXPECT_THAT(html, HasSubstr("<tr data-cell=\"" + cell.id + "\"")) << "not in the ranking";
}

TEST(Page, OfASweepWithoutPicturesDoesNotRankItsSettings) {
    const std::string html = page_of(testing::without_pictures(testing::synthetic_results()));
    EXPECT_THAT(html, HasSubstr("<section id=\"sweeps\""));
    EXPECT_THAT(html, Not(HasSubstr("<section id=\"ranking\"")));
}

TEST(Page, EscapesWhatUsersName) {
    Results results = testing::synthetic_results();
    const std::string hostile = "\"><script>alert('x')</script>&{{lead}}";
    results.cells[0].method_label = hostile;
    results.cells[0].parameters["note"] = hostile;
    results.cells.back().error = hostile;
    results.command = hostile;
    results.cpu = hostile;
    results.warnings = {hostile};
    results.views[0].view_note = hostile;
    results.tables[0].definition["title"] = hostile;
    results.tables[0].definition["notes"][0] = hostile;
    const std::string html = page_of(results);
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert"));
    EXPECT_THAT(html, HasSubstr("{{lead}}")) << "a name was taken for a part of the template";
}

TEST(Page, NeverPrintsNumbersThatAreNone) {
    Results results = testing::synthetic_results();
    results.cells[0].ao = {};
    results.cells[0].frame_ms.reset();
    results.cells[0].fetches_per_pixel.reset();
    results.cells[0].ranked["psnr"] = {std::nullopt, "the images are equal"};
    results.cells.back().error = "the context was lost";
    const std::string text = visible_text(page_of(results));
    EXPECT_FALSE(std::regex_search(text, std::regex("\\b(nan|NaN|inf|null|undefined)\\b")));
    EXPECT_THAT(text, HasSubstr("the images are equal"));
}

TEST(Page, IsWrittenAnewAndLeavesNothingElseBehind) {
    const std::filesystem::path folder = testing::output_dir();
    testing::write_synthetic(testing::synthetic_results(), folder);
    write_atomically(folder / "index.html", "old");
    const std::filesystem::path page = write_page(folder);
    EXPECT_EQ(page, folder / "index.html");
    EXPECT_GT(std::filesystem::file_size(page), 10000U);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name == "index.html" || name == "results.json" || name == "views" || name == "cells")
            << name;
    }
}

TEST(Page, IsTheSameForOneAndTwoRuns) {
    const std::filesystem::path folder = testing::output_dir();
    testing::write_synthetic(testing::synthetic_results(), folder);
    const std::string first = read_file(write_page(folder));
    EXPECT_EQ(first, read_file(write_page(folder)));
}

void expect_file_error(const std::filesystem::path& folder) {
    try {
        write_page(folder);
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "index.html"));
}

TEST(Page, NeedsResults) {
    expect_file_error(testing::output_dir());
}

TEST(Page, NeedsTheImagesThatResultsName) {
    const std::filesystem::path folder = testing::output_dir();
    const Results results = testing::synthetic_results();
    testing::write_synthetic(results, folder);
    std::filesystem::remove(folder / results.cells[0].image_file);
    expect_file_error(folder);
}

TEST(Page, ReadsNoImageOutsideItsFolder) {
    const std::filesystem::path folder = testing::output_dir();
    Results results = testing::synthetic_results();
    testing::write_synthetic(results, folder);
    results.cells[0].image_file = "cells/../../elsewhere.exr";
    write_results(results, folder);
    expect_file_error(folder);
}

TEST(Page, NeedsACellForEachRowOfATable) {
    const std::filesystem::path folder = testing::output_dir();
    Results results = testing::synthetic_results();
    results.tables[0].cell_ids.pop_back();
    testing::write_synthetic(results, folder);
    expect_file_error(folder);
}

}  // namespace
}  // namespace aoscore
