// Tables get the step to tuned presets, and nothing else that they measure changes by it.
#include "plan/plan.h"
#include "screen/method/method.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

std::vector<std::string> table_ids() {
    std::vector<std::string> ids;
    for (const ExperimentDefinition& experiment : list_experiments()) {
        if (experiment.kind == ExperimentDefinition::Kind::table) ids.push_back(experiment.id);
    }
    return ids;
}

TEST(TunedRows, StandBehindAllOtherCellsAsSteps) {
    const ExperimentPlan plan = plan_experiments(table_ids());
    for (const ViewPlan& view : plan.views) {
        bool steps_began = false;
        for (const CellPlan& cell : view.cells) {
            EXPECT_FALSE(steps_began && !cell.step) << cell.method;
            steps_began |= cell.step;
        }
    }
}

TEST(TunedRows, TakeAsManyTapsAsTheirRows) {
    const ExperimentPlan plan = plan_experiments(table_ids());
    const std::vector<MethodDescriptor> methods = load_methods();
    std::size_t measured = 0;
    for (const TablePlan& table : plan.tables) {
        ASSERT_EQ(table.tuned.size(), table.cell_indices.size());
        const ViewPlan& view = plan.views.at(table.view_index);
        for (std::size_t i = 0; i < table.tuned.size(); ++i) {
            const AdvicePlan& step = table.tuned[i].step;
            EXPECT_EQ(step.cell_index, table.cell_indices[i]);
            if (step.steps.empty()) {
                EXPECT_EQ(step.skipped.size(), 1U);
                continue;
            }
            ++measured;
            const CellPlan &row = view.cells.at(step.cell_index),
                           &tuned = view.cells.at(*step.steps.at(0).cell_index);
            const MethodDescriptor& method = find_method(methods, row.method);
            EXPECT_EQ(tuned.method, row.method);
            for (const Parameter& p : method.parameters) {
                if (!p.taps) continue;
                EXPECT_EQ(method.values(tuned.preset, tuned.overrides).at(p.id),
                          method.values(row.preset, row.overrides).at(p.id))
                    << row.method << " " << p.id;
            }
        }
    }
    EXPECT_GE(measured, 6U);
}

TEST(TunedRows, AreInNoFirstAnswer) {
    ExperimentPlan plan = plan_experiments({"hussain-table-3"});
    const std::size_t rows = plan.tables.at(0).cell_indices.size();
    plan = first_answer_of(std::move(plan));
    EXPECT_TRUE(plan.tables.at(0).tuned.empty());
    EXPECT_EQ(plan.views.at(0).cells.size(), rows);
}

}  // namespace
}  // namespace aoscore
