// `aoscore score --advise`: steps are what a score of the changed settings gives.
#include "results/results.h"
#include "results/step_kinds.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

constexpr const char* kScore = "score pillar --view main --size 96x54 --samples 64 --methods ";

const StepRecord* find_step(const AdviceRecord& advice, const std::string& id, const std::string& what) {
    const auto found = std::ranges::find_if(
        advice.steps, [&](const StepRecord& step) { return step.id == id && step.what == what; });
    return found == advice.steps.end() ? nullptr : &*found;
}

TEST(Advise, GivesTheNumbersThatAScoreOfTheChangedSettingsGives) {
    const auto folder = output_dir();
    const ProgramRun run = run_aoscore(std::string(kScore) + "gtao --advise --out advised", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("more taps (slices 3 to 6)"));
    const Results results = read_results(folder / "advised");
    ASSERT_EQ(results.cells.size(), 1U) << "steps are no contestants";
    ASSERT_EQ(results.advice.size(), 1U);
    const AdviceRecord& advice = results.advice[0];
    const StepRecord* slices = find_step(advice, "more-taps", "slices 3 to 6");
    const StepRecord* band = find_step(advice, "guard-band", "10% on every side");
    ASSERT_TRUE(slices != nullptr && band != nullptr) << run.out;
    EXPECT_NEAR(*slices->fetches, 36, 1e-6) << "3 slices of 6 taps on 2 sides";
    for (const auto& [option, step] :
         {std::pair("--set slices=6", slices), std::pair("--guard-band 10%", band)}) {
        const ProgramRun changed =
            run_aoscore(std::string(kScore) + "gtao " + option + " --out changed", folder);
        ASSERT_EQ(changed.exit_code, 0) << changed.err;
        const CellRecord cell = read_results(folder / "changed").cells.at(0);
        EXPECT_EQ(*step->error, *cell.ranked.at("rmse_debiased").value) << option;
    }
}

// Each kind of step is measured or left out with its reason, for every method that is scored, and no other
// table knows of it.
TEST(Advise, EitherMeasuresAStepOfEveryKindOrSaysWhyNot) {
    const auto folder = output_dir();
    const ProgramRun run =
        run_aoscore(std::string(kScore) +
                        "hbao-plus,crytek-ssao,filament-ssao,multi-resolution,ray-march --advise "
                        "--fail 'rmse_debiased>0.9' --export a.csv --out o",
                    folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "o");
    std::set<std::string> advised;
    for (const AdviceRecord& advice : results.advice) {
        advised.insert(advice.cell_id);
        for (const StepKind& kind : step_kinds()) {
            const bool measured =
                std::ranges::find(advice.steps, kind.id, &StepRecord::id) != advice.steps.end();
            const auto skipped = std::ranges::find(advice.skipped, kind.id, &SkippedStep::id);
            EXPECT_TRUE(measured || skipped != advice.skipped.end()) << advice.cell_id << " " << kind.id;
            EXPECT_TRUE(skipped == advice.skipped.end() || !skipped->reason.empty()) << kind.id;
        }
        EXPECT_TRUE(std::ranges::none_of(advice.steps, [](const StepRecord& step) {
            return step.verdict == StepRecord::kFailed;
        })) << run.out;
    }
    for (const CellRecord& cell : results.cells) {
        EXPECT_EQ(advised.contains(cell.id), cell.role == kMethodRole)
            << cell.id << ": a bound has no next step";
        EXPECT_EQ(cell.setting.find("guard-band"), std::string::npos);
    }
}

// The rays that a truth takes follow from what is scored, not from what advice tries beside it.
TEST(Advise, ChangesNothingThatAScoreSays) {
    const auto folder = output_dir();
    const std::string score =
        "score pillar --view main --size 96x54 --methods gtao,crytek-ssao,alchemy,hbao ";
    ASSERT_EQ(run_aoscore(score + "--out plain", folder).exit_code, 0);
    ASSERT_EQ(run_aoscore(score + "--advise --out advised", folder).exit_code, 0);
    const Results plain = read_results(folder / "plain"), advised = read_results(folder / "advised");
    EXPECT_EQ(plain.views.at(0).samples, advised.views.at(0).samples);
    ASSERT_EQ(plain.cells.size(), advised.cells.size());
    for (std::size_t i = 0; i < plain.cells.size(); ++i) {
        EXPECT_EQ(plain.cells[i].id, advised.cells[i].id);
        EXPECT_EQ(plain.cells[i].ranked.at("rmse_debiased").value,
                  advised.cells[i].ranked.at("rmse_debiased").value);
    }
}

}  // namespace
}  // namespace aoscore
