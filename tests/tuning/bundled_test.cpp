// The presets that come tuned are those of a definition, and say what they are worth.
#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/strict_json.h"
#include "metrics/evaluate.h"
#include "screen/method/preset_tuning.h"
#include "tuning/search_axis.h"
#include "tuning/tuning_definition.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

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

/// The methods that a definition leaves out, with the reason of each.
nlohmann::json left_out_of(const std::string& definition) {
    return parse_json_file(tuning_definition_file(definition)).value("left_out", nlohmann::json::object());
}

TEST(TunedPresets, ExistForEveryMethodUnlessTheDefinitionSaysWhyNot) {
    const nlohmann::json left_out = left_out_of("tuned-presets");
    for (const MethodDescriptor& method : load_methods())
        EXPECT_NE(method.presets.contains("tuned"), left_out.contains(method.id)) << method.id;
}

// A method without a number to tune is refused as such; one of a bound is never used.
TEST(TunedPresets, AreMissingWhereNothingIsFree) {
    for (const MethodDescriptor& method : load_methods()) {
        if (method.presets.contains("tuned") || method.role == MethodRole::bound) continue;
        if (!left_out_of("tuned-presets").at(method.id).get<std::string>().starts_with("no parameter"))
            continue;
        EXPECT_THROW(search_axes(method, "default", {}, false), Error) << method.id;
    }
}

/// The rows of the table in shaders/README.md by method: what stands between the other bars.
std::map<std::string, std::string> rows_of_readme() {
    std::map<std::string, std::string> rows;
    std::istringstream lines(read_file(data_dir() / "shaders" / "README.md"));
    bool in_table = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("| tuned method |")) in_table = true;
        if (line.empty()) in_table = false;
        const std::size_t end = line.find("` |");
        if (in_table && line.starts_with("| `") && end != std::string::npos)
            rows[line.substr(3, end - 3)] = line.substr(end + 2);
    }
    return rows;
}

TEST(TunedPresets, StandInTheReadmeWithTheNumbersOfTheirDescriptors) {
    std::map<std::string, std::string> rows = rows_of_readme();
    for (const MethodDescriptor& method : load_methods()) {
        const auto found = method.tunings.find("tuned");
        if (found == method.tunings.end()) continue;
        const PresetTuning& t = found->second;
        EXPECT_EQ(rows[method.id],
                  fmt::format("| {:.4f} | {:.4f} | {:.4f} | {:+.4f} ({:+.4f} to {:+.4f}) |", t.published,
                              t.fitted, *t.held_out, *t.change, *t.low, *t.high));
        rows.erase(method.id);
    }
    EXPECT_TRUE(rows.empty()) << rows.begin()->first;
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
