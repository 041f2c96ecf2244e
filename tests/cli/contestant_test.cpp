// Images of other programs, ranked among the methods.
#include "core/files.h"
#include "image/image_file.h"
#include "results/results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

constexpr const char* kScore = "score wall --view oblique --size 64x48 --samples 8 --methods alchemy";

void describe(const fs::path& folder, const std::string& images, const std::string& more = {}) {
    write_atomically(folder / "contestant.json",
                     R"({"id": "engine", "label": "My engine", "encoding": "linear",
                         "signal": "visibility", "channel": "Y")" +
                         more + R"(, "images": {)" + images + "}}");
}

const CellRecord& cell_of(const Results& results, const std::string& method) {
    return *std::ranges::find_if(results.cells,
                                 [&](const CellRecord& cell) { return cell.method == method; });
}

class Contestant : public ::testing::Test {
  protected:
    /// A score of a method, whose images lie in `folder`/first.
    void SetUp() override {
        const auto run = run_aoscore(std::string(kScore) + " --out first", folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        method = cell_of(read_results(folder / "first"), "alchemy");
        image = *read_image(folder / "first" / method.image_file).channel("Y");
    }

    testing::ProgramRun score_with(const std::string& options) const {
        return run_aoscore(std::string(kScore) + " --out page " + options, folder);
    }

    /// The contestant's row when the folder has only this image.
    CellRecord row_of(const ImageF& changed, int exit_code, const std::string& more = {}) const {
        const ChannelView channel{"Y", &changed};
        write_exr(folder / "engine/oblique.exr", std::span(&channel, 1), {});
        describe(folder / "engine", R"("oblique": "oblique.exr")", more);
        const auto run = score_with("--contestant engine");
        EXPECT_EQ(run.exit_code, exit_code) << run.err;
        const Results results = read_results(folder / "page");
        EXPECT_EQ(cell_of(results, "alchemy").error, "");
        return cell_of(results, "engine");
    }

    const fs::path folder = output_dir();
    CellRecord method;
    ImageF image;
};

TEST_F(Contestant, ThatHoldsAMethodsOwnImagesScoresAsThatMethodDoesToTheBit) {
    const CellRecord row = row_of(image, 0);
    EXPECT_EQ(row.error, "");
    EXPECT_EQ(row.method_label, "My engine");
    ASSERT_FALSE(row.ranked.empty());
    for (const auto& [id, measured] : method.ranked) EXPECT_EQ(row.ranked.at(id).value, measured.value) << id;
    EXPECT_FALSE(row.ao.median_ms) << "its cost is not known";
    EXPECT_FALSE(row.fetches_per_pixel);
    const Results results = read_results(folder / "page");
    ASSERT_EQ(results.rankings.size(), 1U);
    EXPECT_EQ(results.rankings[0].places.size(), 2U) << "ranked among the methods";
    EXPECT_THAT(read_file(folder / "page/index.html"), HasSubstr("My engine"));
}

TEST_F(Contestant, IsReadAsItsDescriptionSays) {
    ImageF coded = image;
    for (float& v : coded.pixels) v = 1 - v;
    const ChannelView channel{"Y", &coded};
    write_exr(folder / "engine/oblique.exr", std::span(&channel, 1), {});
    write_atomically(folder / "engine/contestant.json",
                     R"({"id": "engine", "label": "My engine", "encoding": "linear", "signal": "occlusion",
                         "stated_cost": {"ms": 0.8, "on": "a graphics card"},
                         "images": {"oblique": "oblique.exr"}})");
    const auto run = score_with("--contestant engine");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const CellRecord row = cell_of(read_results(folder / "page"), "engine");
    EXPECT_NEAR(*row.ranked.at("rmse").value, *method.ranked.at("rmse").value, 1e-6);
    EXPECT_EQ(row.parameters.at("stated_ms"), 0.8) << "stated, and beside no time that was measured here";
    EXPECT_FALSE(row.ao.median_ms);
}

TEST_F(Contestant, IsScoredAgainWhenItsImageHasChangedAndOnlyThen) {
    const double before = *row_of(image, 0).ranked.at("rmse").value;
    const auto again = score_with("--contestant engine");
    EXPECT_THAT(again.err, HasSubstr("all measured before"));
    ImageF darker = image;
    for (float& v : darker.pixels) v *= 0.5F;
    EXPECT_NE(*row_of(darker, 0).ranked.at("rmse").value, before);
}

TEST_F(Contestant, WithAnImageThatCannotBeScoredIsAFailedRow) {
    EXPECT_THAT(row_of(ImageF(32, 48, 1.0F), 5).error, HasSubstr("is 32x48 pixels"));
    ImageF holed = image;
    holed.at(32, 24) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(row_of(holed, 5).error, HasSubstr("1 pixels are NaN or infinite"));

    describe(folder / "engine", R"("oblique": "absent.exr")");
    EXPECT_EQ(score_with("--contestant engine").exit_code, 5);
    EXPECT_THAT(cell_of(read_results(folder / "page"), "engine").error, HasSubstr("absent.exr"));

    describe(folder / "engine", R"("front": "oblique.exr")");
    EXPECT_EQ(score_with("--contestant engine").exit_code, 5);
    EXPECT_THAT(cell_of(read_results(folder / "page"), "engine").error,
                HasSubstr("has no image of the view oblique"));
}

TEST(ContestantFolder, ThatIsNotUnderstoodIsRefusedWithItsPlace) {
    const fs::path folder = output_dir();
    const std::string images = R"("images": {"oblique": "a.exr"})";
    const std::string rest = R"("encoding": "linear", "signal": "visibility", )" + images + "}";
    for (
        const auto& [text, said] : {
            std::pair<std::string, std::string>("{", "contestant.json"),
            {R"({"label": "L", )" + rest, "id"},
            {R"({"id": "My Engine", "label": "L", )" + rest, "is no id"},
            {R"({"id": "alchemy", "label": "L", )" + rest, "another contestant"},
            {R"({"id": "e", "label": "L", "gamma": 2, )" + rest, "gamma"},
            {R"({"id": "e", "label": "L", "encoding": "srbg", "signal": "visibility", )" + images + "}",
             "did you mean srgb?"},
            {R"({"id": "e", "label": "L", "encoding": "linear", "signal": "depth", )" + images + "}",
             "visibility, occlusion"},
            {R"({"id": "e", "label": "L", "encoding": "linear", "signal": "visibility", "images": {}})",
             "names no image"},
            {R"({"id": "e", "label": "L", "encoding": "linear", "signal": "visibility", "images": {"a": 1}})",
             "a file's name"},
        }) {
        write_atomically(folder / "engine/contestant.json", text);
        const auto run = run_aoscore(std::string(kScore) + " --contestant engine --out page", folder);
        EXPECT_EQ(run.exit_code, 4) << text << run.err;
        EXPECT_THAT(run.err, HasSubstr(said)) << text;
        EXPECT_THAT(run.err, HasSubstr("contestant.json")) << text;
    }
    EXPECT_EQ(run_aoscore(std::string(kScore) + " --contestant absent --out page", folder).exit_code, 64);
    EXPECT_FALSE(fs::exists(folder / "page"));
}

}  // namespace
}  // namespace aoscore
