#include "core/error.h"
#include "core/files.h"
#include "results/results.h"
#include "results/results_members.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Gives every member of every record a value of its own, other than its default.
struct Filler {
    int count = 0;

    void operator()(const char*, std::string& text) { text = "text " + std::to_string(++count) + " ä\n\"\\"; }
    template <std::integral T>
    void operator()(const char*, T& number) {
        number = static_cast<T>(1000000 + ++count);
    }
    void operator()(const char*, double& number) { number = ++count / 7.0; }
    void operator()(const char*, ParameterValue& value) {
        const ParameterValue kinds[] = {0.1 * ++count, count, count % 2 == 0,
                                        "word " + std::to_string(count)};
        value = kinds[count % 4];
    }
    void operator()(const char*, json& value) { value = {{"rows", {1, 0.1, "x", nullptr}}, {"n", ++count}}; }
    template <class T>
    void operator()(const char* key, std::optional<T>& value) {
        if (++count % 2 == 0) (*this)(key, value.emplace());
    }
    template <class T>
    void operator()(const char* key, std::vector<T>& values) {
        for (int i = 0; i < 3; ++i) (*this)(key, values.emplace_back());
    }
    template <class T>
    void where_any(const char* key, std::vector<T>& values) {
        (*this)(key, values);
    }
    template <class T>
    void operator()(const char* key, std::map<std::string, T>& values) {
        for (int i = 0; i < 3; ++i) (*this)(key, values["key " + std::to_string(++count)]);
    }
    template <class Record>
    void operator()(const char*, Record& record) {
        visit_members(*this, record);
    }
};

Results filled() {
    Results results;
    Filler filler;
    visit_members(filler, results);
    results.seed = std::numeric_limits<std::uint64_t>::max();
    results.total_seconds = 0.1 + 0.2;
    results.peak_memory_mib = std::numeric_limits<double>::denorm_min();
    results.mask_threshold = 5;  // A whole number is written like an integer and must come back.
    return results;
}

std::string refusal(const json& object) {
    try {
        results_from_json(object, "results.json");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        return e.what();
    }
    return "accepted";
}

TEST(Results, ComeBackFromJsonAsTheyWere) {
    const json once = to_json(filled());
    const Results back = results_from_json(json::parse(once.dump()), "results.json");
    EXPECT_EQ(to_json(back).dump(1), once.dump(1));
    EXPECT_EQ(back.seed, std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(back.total_seconds, 0.1 + 0.2);
    EXPECT_EQ(back.peak_memory_mib, std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(back.mask_threshold, 5);
    EXPECT_EQ(back.views.size(), 3U);
}

// Records are compared member by member as the compiler knows them, so that a member missing in
// results_members.h is noticed.
TEST(Results, ComeBackWithEveryMemberOfACell) {
    Results results;
    CellRecord cell;
    cell.id = "a/b/c";
    cell.view_key = "a/b";
    cell.method = "c";
    cell.method_label = "C";
    cell.role = kBoundRole;
    cell.preset = "quality";
    cell.setting = "directions 8";
    cell.filter = "box-4x4";
    cell.parameters = {{"radius", 0.5}, {"count", 4}, {"on", true}};
    cell.lengths = {{"radius", 0.5, "m", LengthRecord::kSet}};
    cell.error = "none";
    cell.ao = {{1, 2, 4}, 2.0, 1.5, {2, 3, 7}};
    cell.filter_pass = {{}, std::nullopt, std::nullopt};
    cell.layers_processor = {{3}, 3.0, 0.0};
    cell.repeats.emplace();
    cell.light["rmse.cone"] = {0.25, Interval{0.2, 0.3}};
    cell.lit_file = "c-lit.exr";
    cell.frame_ms = 3.25;
    cell.fixed_pass = {{12.5}, 12.5, 0.0, {20}};
    cell.lighting = {{8}, 8.0, 0.0};
    cell.gbuffer = {{5}, 5.0, 0.0};
    cell.gbuffer_bytes = 4096;
    cell.layer_bytes = 8192;
    cell.frame = frame_of(10, 8, 2, 0);
    cell.frame_at_once = {{19}, 19.0, 0.0};
    cell.frame_by_pass = {{21}, 21.0, 0.0};
    cell.nonfinite = 7;
    cell.analysis.emplace().missing.area = 0.125;
    cell.own_truth = "quadratic-1";
    cell.ranked = {{"psnr", {std::nullopt, "the images are identical"}}, {"rmse", {0.0, ""}}};
    cell.image_file = "c.exr";
    results.cells = {cell};
    const CellRecord back = results_from_json(to_json(results), "results.json").cells.at(0);
    const auto& [id, view_key, method, method_label, role, preset, setting, filter, parameters, lengths,
                 error, ao, filter_pass, layers_processor, fixed_pass, lighting, gbuffer, gbuffer_bytes,
                 layer_bytes, frame_ms, frame, frame_at_once, frame_by_pass, fetches_per_pixel, nonfinite,
                 ranked_truth, own_truth, ranked, own, raw, signals, analysis, repeats, light, lit_file,
                 image_file] = back;
    EXPECT_EQ(std::tie(id, view_key, method, method_label, role, preset, setting, filter, parameters, error),
              std::tie(cell.id, cell.view_key, cell.method, cell.method_label, cell.role, cell.preset,
                       cell.setting, cell.filter, cell.parameters, cell.error));
    ASSERT_EQ(lengths.size(), 1U);
    EXPECT_EQ(lengths[0].id, "radius");
    EXPECT_EQ(lengths[0].value, 0.5);
    EXPECT_EQ(lengths[0].unit, "m");
    EXPECT_EQ(lengths[0].origin, "set");
    EXPECT_EQ(ao.runs_ms, cell.ao.runs_ms);
    EXPECT_EQ(ao.median_ms, 2.0);
    EXPECT_EQ(ao.spread_ms, 1.5);
    EXPECT_TRUE(filter_pass.runs_ms.empty());
    EXPECT_EQ(filter_pass.median_ms, std::nullopt);
    EXPECT_EQ(ao.processor_runs_ms, cell.ao.processor_runs_ms);
    EXPECT_EQ(layers_processor.median_ms, 3.0);
    EXPECT_TRUE(repeats);
    EXPECT_EQ(light.at("rmse.cone").value, 0.25);
    EXPECT_EQ(lit_file, "c-lit.exr");
    EXPECT_EQ(light.at("rmse.cone").interval->high, 0.3);
    EXPECT_EQ(frame_ms, 3.25);
    EXPECT_EQ(fetches_per_pixel, std::nullopt);
    EXPECT_EQ(fixed_pass.median_ms, 12.5);
    EXPECT_EQ(fixed_pass.processor_runs_ms, cell.fixed_pass.processor_runs_ms);
    EXPECT_EQ(lighting.median_ms, 8.0);
    EXPECT_EQ(gbuffer.median_ms, 5.0);
    EXPECT_EQ(gbuffer_bytes, 4096.0);
    EXPECT_EQ(layer_bytes, 8192.0);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->frame_ms, 20.0);
    EXPECT_EQ(frame_at_once.median_ms, 19.0);
    EXPECT_EQ(frame_by_pass.median_ms, 21.0);
    EXPECT_EQ(nonfinite, 7U);
    ASSERT_TRUE(analysis);
    EXPECT_EQ(analysis->missing.area, 0.125);
    EXPECT_EQ(ranked_truth, "ranked");
    EXPECT_EQ(own_truth, cell.own_truth);
    EXPECT_EQ(ranked.at("psnr").value, std::nullopt);
    EXPECT_EQ(ranked.at("psnr").note, "the images are identical");
    EXPECT_EQ(ranked.at("rmse").value, 0.0);
    EXPECT_TRUE(own.empty() && raw.empty());
    EXPECT_EQ(image_file, "c.exr");
}

/// Counts the members of a plain struct, which the list must visit.
struct Counter {
    int members = 0;
    template <class T>
    void operator()(const char*, T&) {
        ++members;
    }
    template <class T>
    void where_any(const char*, T&) {
        ++members;
    }
};
template <class Record>
int listed() {
    Record record;
    Counter counter;
    visit_members(counter, record);
    return counter.members;
}

struct Anything {
    template <class T>
    operator T() const;  // NOLINT: converts on purpose
};
template <class Record, class... Initial>
constexpr int declared() {
    if constexpr (requires { Record{Initial{}..., Anything{}}; }) {
        return declared<Record, Initial..., Anything>();
    } else {
        return sizeof...(Initial);
    }
}

TEST(Results, ListOfMembersForgetsNone) {
    EXPECT_EQ(listed<MeasuredMetric>(), declared<MeasuredMetric>());
    EXPECT_EQ(listed<Timing>(), declared<Timing>());
    EXPECT_EQ(listed<Interval>(), declared<Interval>());
    EXPECT_EQ(listed<BestFit>(), declared<BestFit>());
    EXPECT_EQ(listed<CauseShare>(), declared<CauseShare>());
    EXPECT_EQ(listed<MaskSummary>(), declared<MaskSummary>());
    EXPECT_EQ(listed<ErrorRegion>(), declared<ErrorRegion>());
    EXPECT_EQ(listed<SplitBin>(), declared<SplitBin>());
    EXPECT_EQ(listed<Split>(), declared<Split>());
    EXPECT_EQ(listed<ErrorDistribution>(), declared<ErrorDistribution>());
    EXPECT_EQ(listed<MapSums>(), declared<MapSums>());
    EXPECT_EQ(listed<MeasureRecord>(), declared<MeasureRecord>());
    EXPECT_EQ(listed<BlockErrors>(), declared<BlockErrors>());
    EXPECT_EQ(listed<BinBlocks>(), declared<BinBlocks>());
    EXPECT_EQ(listed<AngleBlocks>(), declared<AngleBlocks>());
    EXPECT_EQ(listed<TunedRowRecord>(), declared<TunedRowRecord>());
    EXPECT_EQ(listed<ErrorAnalysis>(), declared<ErrorAnalysis>());
    EXPECT_EQ(listed<TruthRecord>(), declared<TruthRecord>());
    EXPECT_EQ(listed<ViewRecord>(), declared<ViewRecord>());
    EXPECT_EQ(listed<CellRecord>(), declared<CellRecord>());
    EXPECT_EQ(listed<RankRange>(), declared<RankRange>());
    EXPECT_EQ(listed<PlaceRecord>(), declared<PlaceRecord>());
    EXPECT_EQ(listed<RankingRecord>(), declared<RankingRecord>());
    EXPECT_EQ(listed<ChangeRecord>(), declared<ChangeRecord>());
    EXPECT_EQ(listed<BaselineRecord>(), declared<BaselineRecord>());
    EXPECT_EQ(listed<TableRecord>(), declared<TableRecord>());
    EXPECT_EQ(listed<Results>() + 1, declared<Results>()) << "the schema is written as today's";
}

TEST(Results, EmptyValuesAreNullAndNeverNan) {
    Results results;
    results.cells.resize(1);
    results.cells[0].ranked["psnr"] = {std::nullopt, "why"};
    const json object = to_json(results);
    EXPECT_TRUE(object.at("cells")[0].at("ranked").at("psnr").at("value").is_null());
    EXPECT_TRUE(object.at("cells")[0].at("frame_ms").is_null());

    results.cells[0].ranked["psnr"].value = std::numeric_limits<double>::quiet_NaN();
    try {
        to_json(results);
        FAIL() << "NaN was written";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::internal);
        EXPECT_THAT(e.where(), HasSubstr("results.cells[0].ranked.psnr.value"));
    }
}

TEST(Results, AnotherSchemaVersionIsRefused) {
    json object = to_json(Results{});
    EXPECT_EQ(object.at("schema_version"), Results::kSchemaVersion);
    object["schema_version"] = Results::kSchemaVersion + 1;
    object["from_the_future"] = 1;
    EXPECT_THAT(refusal(object),
                HasSubstr(fmt::format("schema_version: is {}", Results::kSchemaVersion + 1)));
    object.erase("schema_version");
    EXPECT_THAT(refusal(object), HasSubstr("schema_version: is missing"));
}

TEST(Results, MissingUnknownAndMistypedMembersAreErrorsThatNameTheirPlace) {
    const json whole = to_json(filled());
    json object = whole;
    object["cells"][1].erase("nonfinite");
    EXPECT_THAT(refusal(object), HasSubstr("results.json: cells[1].nonfinite: is missing"));
    object = whole;
    object["views"][2]["extra"] = 1;
    EXPECT_THAT(refusal(object), HasSubstr("results.json: views[2].extra: unknown key"));
    object = whole;
    object["views"][0]["near_m"] = nullptr;
    EXPECT_THAT(refusal(object), HasSubstr("results.json: views[0].near_m: is null (valid: a number)"));
    object = whole;
    object["views"][0]["width"] = 3e9;
    EXPECT_THAT(refusal(object), HasSubstr("width"));
    object["views"][0]["width"] = 3000000000;
    EXPECT_THAT(refusal(object), HasSubstr("width"));
    object = whole;
    object["seed"] = -1;
    EXPECT_THAT(refusal(object), HasSubstr("seed: is -1"));
    object = whole;
    object["warnings"] = "one";
    EXPECT_THAT(refusal(object), HasSubstr("warnings: is \"one\" (valid: an array)"));
}

TEST(ResultsFile, ComesBackFromItsFolder) {
    const auto folder = testing::output_dir() / "made" / "on demand";
    write_results(filled(), folder);
    EXPECT_EQ(to_json(read_results(folder)), to_json(filled()));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1)
        << "a temporary file is left";
}

TEST(ResultsFile, TakesNamesThatAreNotUtf8) {
    const auto folder = testing::output_dir();
    Results results;
    results.command =
        "aoscore score b\xfc"
        "ro.glb";
    write_results(results, folder);
    EXPECT_EQ(read_results(folder).command, "aoscore score b\xef\xbf\xbdro.glb");
}

TEST(ResultsFile, TruncatedOrAbsentIsAnErrorThatNamesTheFile) {
    const auto folder = testing::output_dir();
    const auto message = [&] {
        try {
            read_results(folder);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::file_error);
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(message(), HasSubstr("results.json: no such file"));
    const std::string whole = to_json(filled()).dump();
    std::ofstream(folder / "results.json") << whole.substr(0, whole.size() / 2);
    EXPECT_THAT(message(), HasSubstr("results.json"));
}

TEST(ResultsFile, HasALineForEachArrayOfNumbersAndLeavesTextAsItIs) {
    const auto folder = testing::output_dir();
    Results results;
    results.command = R"(aoscore [ 1, 2 ]  "[ 3 ]\" [)";
    results.warnings = {"[ 1 ]", "two"};
    CellRecord& cell = results.cells.emplace_back();
    cell.ao.runs_ms = {1, 2.5, 3};
    write_results(results, folder);
    EXPECT_EQ(to_json(read_results(folder)), to_json(results));
    const std::string text = read_file(folder / "results.json");
    EXPECT_THAT(text, HasSubstr("[1.0,2.5,3.0]"));
    EXPECT_THAT(text, HasSubstr("\"[ 1 ]\",\n"));
}

// All claims together made 80 MB when each number had a line.
TEST(ResultsFile, MayBeLargerThanOtherFiles) {
    Results results;
    results.command = std::string(std::size_t{65} << 20, 'x');
    const std::filesystem::path folder = testing::output_dir();
    write_results(results, folder);
    EXPECT_EQ(read_results(folder).command.size(), results.command.size());
}

}  // namespace
}  // namespace aoscore
