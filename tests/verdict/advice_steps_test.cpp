// The steps that advice plans exist for every method, and change what they say.
#include "plan/advice_steps.h"

#include "results/step_kinds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace aoscore {
namespace {

/// A plan of every method as it is scored, with its steps.
ExperimentPlan advised(const Registry& registry) {
    ExperimentPlan plan;
    ViewPlan& view = plan.views.emplace_back();
    for (const MethodDescriptor& method : registry.methods) {
        for (const CellPlan& cell : scored_cells(method)) shared_cell(view, cell);
    }
    add_advice(plan, registry);
    return plan;
}

TEST(AdviceSteps, OfEveryMethodNameWhatExistsAndAreDrawnOtherwise) {
    const Registry registry = load_registry();
    const ExperimentPlan plan = advised(registry);
    EXPECT_GT(plan.advice.size(), registry.methods.size() / 2);
    for (const AdvicePlan& advice : plan.advice) {
        const std::vector<CellPlan>& cells = plan.views[0].cells;
        for (const StepKind& kind : step_kinds()) {
            EXPECT_TRUE(std::ranges::find(advice.steps, kind.id, &StepPlan::id) != advice.steps.end() ||
                        std::ranges::find(advice.skipped, kind.id, &SkippedStep::id) != advice.skipped.end())
                << cells[advice.cell_index].method << " " << kind.id;
        }
        for (const StepPlan& step : advice.steps) {
            if (!step.cell_index) continue;
            ASSERT_NE(*step.cell_index, advice.cell_index);
            EXPECT_NO_THROW(resolve(cells[*step.cell_index], registry, 1, 0.5))
                << cells[advice.cell_index].method << " " << step.id;
        }
    }
}

TEST(AdviceSteps, AreNoPartOfAFirstAnswer) {
    const Registry registry = load_registry();
    const ExperimentPlan first = first_answer_of(advised(registry));
    EXPECT_TRUE(first.advice.empty());
    EXPECT_TRUE(std::ranges::none_of(first.views[0].cells, &CellPlan::step));
}

TEST(AdviceSteps, OfALargerRadiusScaleTheMethodsLengthsAndNotTheFilters) {
    const Registry registry = load_registry();
    CellPlan cell;
    cell.method = "visibility-bitmask";
    cell.preset = "published";
    CellPlan wide = cell;
    wide.radius_factor = 1.5;
    const ResolvedCell before = resolve(cell, registry, 1, 2.0), after = resolve(wide, registry, 1, 2.0);
    EXPECT_DOUBLE_EQ(after.request.parameters.at("radius").number(), 3.0);
    EXPECT_DOUBLE_EQ(after.request.parameters.at("thickness").number(),
                     1.5 * before.request.parameters.at("thickness").number());
    EXPECT_EQ(after.request.filter_parameters, before.request.filter_parameters);
    EXPECT_NE(cell_name(cell), cell_name(wide));
}

}  // namespace
}  // namespace aoscore
