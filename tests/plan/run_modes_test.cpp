// Tests the modes of a run, which results list among a cell's parameters.
#include "plan/run_modes.h"

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

}  // namespace
}  // namespace aoscore
