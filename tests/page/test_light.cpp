// Tests the section of light by an environment.
#include "core/files.h"
#include "image/image_file.h"
#include "page/page.h"
#include "page/pictures/lit_picture.h"
#include "results/light_modes.h"
#include "support/support.h"
#include "synthetic_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace aoscore::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ColourPlanes gray(const ViewRecord& view, float value) {
    const ImageF plane(view.width, view.height, value);
    return {plane, plane, plane};
}

/// Results of which one cell is lit by all modes, the other by its normal alone.
Results lit_results(const std::filesystem::path& folder) {
    Results results = synthetic_results();
    ViewRecord& view = results.views.front();
    view.light = {.environment = "court <yard>.hdr",
                  .file = "views/light.exr",
                  .mean = 0.8,
                  .standard_error = 0.004,
                  .samples = 64,
                  .of_truth = {}};
    for (const LightMode& mode : light_modes()) {
        for (const std::string& id : mode.measures())
            view.light->of_truth[id] = {0.0321, Interval{0.03, 0.034}};
    }
    std::vector<CellRecord*> cells;
    for (CellRecord& cell : results.cells) {
        if (cell.view_key == view.key && !cell.image_file.empty()) cells.push_back(&cell);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        for (const LightMode& mode : light_modes()) {
            if (i == 1 && mode.bent) continue;
            for (const std::string& id : mode.measures())
                cells[i]->light[id] = {i == 0 ? 0.1234 : 0.2345, Interval{0.1, 0.3}};
        }
        cells[i]->lit_file = "cells/lit" + std::to_string(i) + ".exr";
    }
    write_synthetic(results, folder);
    const ColourPlanes traced = gray(view, 0.8F), lit = gray(view, 0.9F);
    write_exr(folder / view.light->file,
              std::vector<ChannelView>{{"R", &traced[0]}, {"G", &traced[1]}, {"B", &traced[2]}}, {});
    for (std::size_t i = 0; i < 2; ++i) {
        std::vector<ChannelView> channels;
        for (const LightMode& mode : light_modes()) {
            if (i == 1 && mode.bent) continue;
            for (std::size_t c = 0; c < 3; ++c) channels.push_back({mode.channels()[c], &lit[c]});
        }
        write_exr(folder / cells[i]->lit_file, channels, {});
    }
    return results;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(LightSection, IsLeftOutWhereNothingWasLit) {
    const auto folder = output_dir();
    write_synthetic(synthetic_results(), folder);
    EXPECT_THAT(read_file(write_page(folder)), Not(HasSubstr("id=\"light\"")));
}

TEST(LightSection, HasATableAndPicturesOfEveryModeThatAMethodHas) {
    const auto folder = output_dir();
    lit_results(folder);
    const std::string page = read_file(write_page(folder));
    EXPECT_NE(page.find("id=\"light\""), std::string::npos);
    EXPECT_NE(page.find("court &lt;yard&gt;.hdr"), std::string::npos);
    for (const LightMode& mode : light_modes())
        EXPECT_NE(page.find(std::string(mode.label)), std::string::npos);
    EXPECT_NE(page.find(">12.3<span class=\"unit\">10.0 to 30.0<"), std::string::npos);
    EXPECT_NE(page.find(">3.2<"), std::string::npos) << "the truth's own signals";
    EXPECT_NE(page.find("title=\"it lacks the signals\">–<"), std::string::npos);
    EXPECT_EQ(count_of(page, "alt=\"Light of "), light_modes().size() + 1);
    EXPECT_EQ(count_of(page, "alt=\"Error of the light of "), light_modes().size() + 1);
    EXPECT_EQ(count_of(page, "alt=\"Ray-traced irradiance on "), 1u);
    EXPECT_EQ(count_of(page, "<h4>By the "), light_modes().size()) << "methods stand side by side";
    EXPECT_NE(page.find("0.50 % of that mean"), std::string::npos) << "the standard error";
}

/// The page of lit results whose second method has that interval about its error.
std::string page_with(const std::filesystem::path& folder, const Interval& second) {
    Results results = lit_results(folder);
    int lit = 0;
    for (CellRecord& cell : results.cells) {
        for (auto& [id, measure] : cell.light) measure.interval = lit == 0 ? Interval{0.1, 0.15} : second;
        lit += !cell.light.empty();
    }
    write_synthetic(results, folder);
    return read_file(write_page(folder));
}

TEST(LightSection, NamesOneMethodTheClosestOnlyWhereItsIntervalLiesBelowTheOthers) {
    const auto folder = output_dir();
    const std::string told_apart = page_with(folder, {0.2, 0.3});
    EXPECT_THAT(told_apart, HasSubstr("lights closest of 2 methods"));
    EXPECT_THAT(told_apart, Not(HasSubstr("equally close")));
    const std::string overlapping = page_with(folder, {0.14, 0.3});
    EXPECT_THAT(overlapping, HasSubstr("all 2 methods light equally close"));
    EXPECT_THAT(overlapping, Not(HasSubstr("lights closest")));
}

/// The first pixel of a PNG of eight bits in a data URI is what a browser shows: it is compared as text.
TEST(LitPicture, DependsOnTheShareOfWhiteAlone) {
    const ViewRecord view = synthetic_results().views.front();
    EXPECT_EQ(lit_picture(gray(view, 0.4F), 0.8, 480).uri, lit_picture(gray(view, 2), 4, 480).uri);
    EXPECT_EQ(lit_picture(gray(view, 3), 1, 480).uri, lit_picture(gray(view, 1), 1, 480).uri) << "clipped";
    EXPECT_NE(lit_picture(gray(view, 0.4F), 0.8, 480).uri, lit_picture(gray(view, 0.3F), 0.8, 480).uri);
}

TEST(LitPicture, KeepsTheHueOfWhatIsBeyondWhite) {
    const ViewRecord view = synthetic_results().views.front();
    const auto of = [&](float red, float green, float blue) {
        ColourPlanes colours = gray(view, red);
        colours[1] = gray(view, green)[0];
        colours[2] = gray(view, blue)[0];
        return lit_picture(colours, 1, 480).uri;
    };
    EXPECT_EQ(of(4, 2, 1), of(1, 0.5F, 0.25F));
    EXPECT_NE(of(4, 2, 1), of(1, 1, 1)) << "clipped channel by channel";
    EXPECT_NE(of(0.5F, 0.25F, 0.125F), of(1, 0.5F, 0.25F)) << "what is within white is not made brighter";
}

TEST(LitErrorPicture, IsOfTheLuminanceOverTheMean) {
    const ViewRecord view = synthetic_results().views.front();
    const Mask all(view.width, view.height, 1);
    const ImageF truth(view.width, view.height, 1);
    const auto error = [&](const ColourPlanes& colours, double mean) {
        return lit_error_picture(colours, truth, mean, all, 480).uri;
    };
    ColourPlanes green = gray(view, 0);
    std::ranges::fill(green[1].pixels, static_cast<float>(1.25 / 0.7152));
    EXPECT_EQ(error(green, 1), error(gray(view, 1.25F), 1)) << "green of the same luminance";
    EXPECT_EQ(error(gray(view, 1.25F), 1), error(gray(view, 1.125F), 0.5));
    EXPECT_NE(error(gray(view, 1.25F), 1), error(gray(view, 0.75F), 1)) << "too bright is not too dark";
}

}  // namespace
}  // namespace aoscore::testing
