// Tests the modes of a run, which results list among a cell's parameters.
#include "plan/run_modes.h"

#include "core/error.h"
#include "plan/resolved_cell.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(RunModes, ShareNoNameWithAParameterOfAMethodOrFilter) {
    const Registry registry = load_registry();
    for (const auto* const descriptors : {&registry.methods, &registry.filters}) {
        for (const MethodDescriptor& descriptor : *descriptors) {
            for (const RunModeOption& mode : run_mode_options()) {
                EXPECT_FALSE(descriptor.find_parameter(mode.id) != nullptr)
                    << descriptor.id << ", " << mode.id;
            }
        }
    }
}

TEST(RunModes, AreSetToEachOfTheirChoicesAndRefuseOthers) {
    for (const RunModeOption& mode : run_mode_options()) {
        for (const std::string& choice : mode.choices) {
            RunModes modes;
            mode.choose(modes, choice);
            EXPECT_EQ(mode.chosen(modes), choice) << mode.id;
            EXPECT_EQ(unusual_modes(modes).contains(std::string(mode.id)), choice != mode.choices.front());
        }
        RunModes modes;
        EXPECT_THROW(mode.choose(modes, "nonsense"), Error) << mode.id;
        EXPECT_THROW(choose_as_file_says(mode, modes, "nonsense", "a file"), Error) << mode.id;
        EXPECT_EQ(modes, RunModes()) << mode.id;
    }
}

}  // namespace
}  // namespace aoscore
