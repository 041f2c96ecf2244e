// The presets that come tuned are those of a definition, and say what they are worth.
#include "core/strict_json.h"
#include "metrics/evaluate.h"
#include "screen/method/preset_tuning.h"
#include "tuning/tuning_definition.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace aoscore {
namespace {

TEST(TunedPresets, AreThoseOfTheirDefinition) {
    std::size_t tuned = 0;
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [preset, tuning] : method.tunings) {
            ++tuned;
            const std::string about = method.id + "/" + preset;
            const nlohmann::json definition = parse_json_file(tuning_definition_file(tuning.definition));
            const auto& listed = definition.at("methods");
            const auto entry = std::ranges::find_if(
                listed, [&](const nlohmann::json& one) { return one.at("method") == method.id; });
            ASSERT_TRUE(entry != listed.end()) << about;
            EXPECT_EQ(tuning.from, entry->value("preset", "default")) << about;
            EXPECT_EQ(static_cast<std::size_t>(tuning.scenes), definition.at("scenes").size()) << about;
            std::size_t views = 0;
            for (const auto& scene : definition.at("scenes")) views += scene.at("views").size();
            EXPECT_EQ(static_cast<std::size_t>(tuning.views), views) << about;
            metric(tuning.metric);
        }
    }
    EXPECT_GE(tuned, 7U);
}

// What was fitted cannot be farther on the views that it was fitted to, nor closer on those that were left
// out.
TEST(TunedPresets, StateAnOptimismThatIsNoLess) {
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [preset, tuning] : method.tunings) {
            ASSERT_TRUE(tuning.held_out) << method.id;
            EXPECT_LE(tuning.fitted, tuning.published) << method.id;
            EXPECT_LE(tuning.fitted, *tuning.held_out + 1e-12) << method.id;
            EXPECT_LE(*tuning.low, *tuning.change) << method.id;
            EXPECT_LE(*tuning.change, *tuning.high) << method.id;
        }
    }
}

TEST(TunedPresets, AreReadAsTheyAreWritten) {
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [preset, tuning] : method.tunings) {
            const nlohmann::json written = tuning_json(tuning);
            EXPECT_EQ(tuning_json(parse_tuning(StrictObject(written, "tuning"))), written) << method.id;
        }
    }
}

}  // namespace
}  // namespace aoscore
