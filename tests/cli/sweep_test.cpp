// Sweeps and claims through the program, as a user runs them.
#include "core/files.h"
#include "results/results.h"
#include "results/sweep_rows.h"
#include "screen/method/method.h"
#include "support/support.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace aoscore {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::run_aoscore;

TEST(Sweep, MeasuresEverySettingAgainstOneTruthAndWritesACsv) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "sweep wall --view facing --methods alchemy,hbao --vary samples=2,4,8 --vary directions=2,4 --size "
        "48x32 "
        "--samples 8 --budget-ms 1000 --out out",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "out/index.html\n");
    EXPECT_THAT(run.err, HasSubstr("does not apply"));
    const Results results = read_results(folder / "out");
    ASSERT_EQ(results.sweeps.size(), 1u);
    ASSERT_EQ(results.views.size(), 1u);
    EXPECT_EQ(results.views[0].truths.size(), 1u) << "one truth for all";
    const std::vector<SweepRow> rows = sweep_rows(results, results.sweeps[0]);
    ASSERT_EQ(rows.size(), 5u);
    for (const SweepRow& row : rows) {
        EXPECT_TRUE(row.cell->error.empty()) << row.cell->error;
        EXPECT_TRUE(row.cost_ms && row.cost_low_ms && row.relative_cost && row.fitted_error) << row.cell->id;
        EXPECT_LE(*row.cost_low_ms, *row.cost_ms);
        EXPECT_LE(*row.cost_ms, *row.cost_high_ms);
        EXPECT_GE(row.cell->ao.runs_ms.size(), 6u);
        EXPECT_TRUE(row.cell->image_file.empty()) << "nobody asked for pictures";
        EXPECT_TRUE(row.within_budget);
        ASSERT_TRUE(row.frame) << "a sweep's frames are lit";
        EXPECT_GT(row.frame->lighting_ms, 0);
        EXPECT_DOUBLE_EQ(row.frame->geometry_lighting_ms + row.frame->ao_ms + row.frame->filter_ms,
                         row.frame->frame_ms);
        EXPECT_GE(row.cell->lighting.runs_ms.size(), 6u) << "in turns with the cells";
        EXPECT_TRUE(row.cell->frame_at_once.runs_ms.empty()) << "nobody asked for whole frames";
    }
    EXPECT_FALSE(results.views[0].lighting.empty());
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const SweepRow& row) { return row.on_front; }));
    const std::string csv = read_file(folder / "out/sweep.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    EXPECT_THAT(csv, HasSubstr(",lighting_ms,gbuffer_lighting_ms,frame_ms,"));
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("frames a second"));
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("sweep-chart"));
}

TEST(Sweep, FetchesGrowWithTheSamplesOnTheAxis) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "sweep wall --view facing --methods alchemy --vary samples=2,4,8 --size 48x32 --samples 8 --out out",
        folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const CellRecord& cell : read_results(folder / "out").cells)
        EXPECT_DOUBLE_EQ(*cell.fetches_per_pixel, cell.parameters.at("samples").number()) << cell.id;
}

TEST(Sweep, HasOneFrontOverTheViewsOfSeveralScenes) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "sweep wall pit --view facing,above --methods alchemy --vary samples=2,8 --size 32x24 --samples 8 "
        "--out out",
        folder);
    ASSERT_EQ(run.exit_code, 64) << "neither scene has both views: " << run.out;
    const auto both = run_aoscore(
        "sweep wall pit --radius 1 --methods alchemy --vary samples=2,8 --size 32x24 --samples 8 --out out",
        folder);
    ASSERT_EQ(both.exit_code, 0) << both.err;
    const Results results = read_results(folder / "out");
    const std::vector<SweepRow> rows = sweep_rows(results, results.sweeps.at(0));
    const std::vector<SweepRowsOverViews> groups = rows_over_views(rows);
    ASSERT_EQ(groups.size(), 1u);
    const auto& [group_views, all] = groups[0];
    EXPECT_EQ(group_views.size(), results.views.size());
    ASSERT_EQ(all.size(), 2u);
    ASSERT_EQ(rows.size(), 2 * results.views.size());
    for (const SweepRow& combined : all) {
        double squares = 0, costs = 0;
        for (const SweepRow& row : rows) {
            if (row.point->at != combined.point->at) continue;
            squares += *row.error * *row.error;
            costs += *row.cost_ms;
            EXPECT_GT(row.frame->frame_ms, *row.cost_ms) << "the G-buffer is part of a frame";
        }
        const auto views = static_cast<double>(results.views.size());
        EXPECT_NEAR(*combined.error, std::sqrt(squares / views), 1e-12);
        EXPECT_NEAR(*combined.cost_ms, costs / views, 1e-9);
    }
    EXPECT_THAT(read_file(folder / "out/index.html"),
                HasSubstr(fmt::format("Over {} views", results.views.size())));
    EXPECT_THAT(read_file(folder / "out/sweep.csv"),
                HasSubstr(fmt::format(",{} {}", results.views[0].key, results.views[1].key)));
}

TEST(Sweep, DoesNotMixScenesThatAreRankedAtDifferentRadii) {
    const auto folder = output_dir();
    const auto run = run_aoscore(
        "sweep wall pit --methods alchemy --vary samples=2,8 --size 32x24 --samples 8 --out out", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "out");
    for (const SweepRowsOverViews& group : rows_over_views(sweep_rows(results, results.sweeps.at(0)))) {
        for (const ViewRecord* view : group.views) EXPECT_EQ(view->scene, group.views.front()->scene);
    }
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("different radii or sizes"));
}

std::string with_commas(const std::vector<std::string>& ids) {
    return fmt::format("{}", fmt::join(ids, ","));
}

/// The methods of the registry that read several depths a texel, of the view's own camera or of others.
std::vector<std::string> layered_methods() {
    std::vector<std::string> ids;
    for (const MethodDescriptor& method : load_methods()) {
        if (method.depth_layers || method.side_layers) ids.push_back(method.id);
    }
    return ids;
}

TEST(EveryLayeredMethod, StandsBesideWhatOneLayerCannotKnow) {
    const std::vector<std::string> methods = layered_methods();
    ASSERT_GE(methods.size(), 6u);
    const auto folder = output_dir();
    for (const char* command : {"score", "sweep --vary preset=default"}) {
        const auto run = run_aoscore(fmt::format("{} pillar --view main --methods {} --size 96x54 --samples 16 "
                                                 "--out out --export numbers.csv",
                                                 command, with_commas(methods)),
                                     folder);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Results results = read_results(folder / "out");
        for (const std::string& id : methods) {
            const auto cell = std::ranges::find(results.cells, id, &CellRecord::method);
            ASSERT_NE(cell, results.cells.end()) << command << " " << id;
            ASSERT_TRUE(cell->analysis && cell->analysis->found_beyond_layer) << command << " " << id;
            EXPECT_GE(*cell->analysis->found_beyond_layer, 0) << id;
            EXPECT_LE(*cell->analysis->found_beyond_layer, 1) << id;
        }
        EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("Beyond one layer")) << command;
        EXPECT_THAT(read_file(folder / "numbers.csv"), HasSubstr("found_beyond_layer")) << command;
    }
    EXPECT_THAT(read_file(folder / "out/sweep.csv"), HasSubstr(",found_beyond_layer,found_of_layers,"));
}

TEST(Claims, AreJudgedFromWhatWasMeasuredForThem) {
    const auto folder = output_dir();
    const auto run = run_aoscore("claims H14 H33 G37 --scale 0.1 --out out", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "out");
    std::map<std::string, ClaimRecord> by_id;
    for (const ClaimRecord& claim : results.claims) by_id[claim.id] = claim;
    ASSERT_EQ(by_id.size(), 3u);
    EXPECT_EQ(by_id["H33"].verdict, ClaimRecord::kHolds) << by_id["H33"].reason;
    EXPECT_FALSE(by_id["H14"].findings.empty());
    EXPECT_EQ(by_id["G37"].verdict, ClaimRecord::kCannotTell);
    EXPECT_THAT(by_id["G37"].reason, HasSubstr("frames"));
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("claim-H33"));
    EXPECT_EQ(run_aoscore("claims H99", folder).exit_code, 64);
    EXPECT_THAT(run.out, HasSubstr("out/index.html\n"));
    EXPECT_THAT(run.out, HasSubstr("   3 judged:"));
    const auto again =
        run_aoscore("claims H14 H33 G37 --scale 0.1 --out again --before out/results.json", folder);
    EXPECT_THAT(again.out, HasSubstr("no verdict has changed"));
    nlohmann::json earlier = nlohmann::json::parse(read_file(folder / "out/results.json"));
    earlier["claims"][1]["verdict"] = "none";
    earlier["claims"].erase(2);
    write_atomically(folder / "earlier.json", earlier.dump());
    const auto changed =
        run_aoscore("claims H14 H33 G37 --scale 0.1 --out again --before earlier.json", folder);
    const auto line = [](const ClaimRecord& claim, const char* before) {
        return fmt::format("{} {}, before: {}\n", claim.id, claim.verdict, before);
    };
    EXPECT_THAT(changed.out, EndsWith(line(results.claims.at(1), "none") + line(results.claims.at(2), "not judged")));
    const auto missing = run_aoscore("claims H14 --scale 0.1 --before missing.json", folder);
    EXPECT_EQ(missing.exit_code, 4);
    EXPECT_THAT(missing.err, HasSubstr("missing.json: no such file"));
    earlier["claims"].clear();
    write_atomically(folder / "claimless.json", earlier.dump());
    const auto claimless = run_aoscore("claims H14 --scale 0.1 --before claimless.json", folder);
    EXPECT_EQ(claimless.exit_code, 4);
    EXPECT_THAT(claimless.err, HasSubstr("judges no claims"));
}

// One view at several radii is several pictures: none may take another's place.
TEST(Claims, OneViewAtSeveralRadiiIsKeptApart) {
    const auto folder = output_dir();
    const auto run = run_aoscore("claims F48 --scale 0.2 --out out", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "out");
    std::map<std::string, double> radius_by_key;
    for (const ViewRecord& view : results.views) radius_by_key[view.key] = view.radius_m;
    EXPECT_EQ(radius_by_key.size(), results.views.size());
    std::map<std::string, int> cells_by_id;
    for (const CellRecord& cell : results.cells) {
        EXPECT_EQ(++cells_by_id[cell.id], 1) << cell.id;
        EXPECT_EQ(cell.parameters.at("radius").number(), radius_by_key.at(cell.view_key));
    }
    EXPECT_EQ(results.cells.size(), 4u);
}

TEST(Claims, RaysContendWithoutATimeOfTheirOwn) {
    const auto folder = output_dir();
    const auto run = run_aoscore("claims F53 --scale 0.2 --out out", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Results results = read_results(folder / "out");
    ASSERT_FALSE(results.cells.empty());
    for (const CellRecord& cell : results.cells) {
        EXPECT_EQ(cell.method, "ray-traced");
        EXPECT_TRUE(cell.error.empty()) << cell.error;
        EXPECT_FALSE(cell.ao.median_ms);
        // With one ray everything is noise; with more, in so small a picture, the filter does more harm than
        // good.
        if (cell.parameters.at("rays") == 1) {
            EXPECT_LT(*cell.ranked.at("rmse").value, *cell.raw.at("rmse").value) << "the filter mends";
        }
    }
    EXPECT_THAT(read_file(folder / "out/index.html"), HasSubstr("Waldner, Real-time Ray Traced"));
    const auto again = run_aoscore("claims F53 --scale 0.2 --out again", folder);
    EXPECT_THAT(again.err, HasSubstr("all measured before"));
}

}  // namespace
}  // namespace aoscore
