#include "core/files.h"
#include "report/report.h"
#include "report/synthetic_results.h"
#include "results/image_file.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

/// The page in headless Chromium, driven by playwright-core: each specs/*.spec.mjs says what it claims.
/// Screenshots stay in the test's output folder. A machine without Chromium, Node or the npm packages skips
/// these tests and says so; with CI=true they fail there.
namespace aoscore {
namespace {

namespace fs = std::filesystem;

std::string what_is_missing() {
    for (const char* program : {"chromium", "node"}) {
        if (std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) != 0) return program;
    }
    const fs::path packages = home_dir() / "node_modules";
    for (const char* package : {"playwright-core", "axe-core", "html-validate"}) {
        if (!fs::exists(packages / package))
            return (packages / package).string() + " (./test.sh installs it)";
    }
    return "";
}

/// Writes one channel as raw float32 and returns what a spec needs to find it.
nlohmann::json dumped(const fs::path& exr, const std::string& channel, const fs::path& to) {
    const ImageFile file = read_image(exr);
    const ImageF* image = file.channel(channel);
    if (image == nullptr) throw std::runtime_error(exr.string() + " lacks " + channel);
    write_atomically(to, std::string_view(reinterpret_cast<const char*>(image->pixels.data()),
                                          image->pixels.size() * sizeof(float)));
    return {{"file", to.string()}, {"width", image->width}, {"height", image->height}};
}

/// The EXR files' values, by the names that the page gives its images.
nlohmann::json exr_values(const Results& results, const fs::path& folder) {
    nlohmann::json list;
    const auto add = [&](const std::string& name, const std::string& file, const std::string& channel) {
        list[name] = dumped(folder / file, channel, folder / "values" / fmt::format("{}.f32", list.size()));
    };
    for (const ViewRecord& view : results.views) {
        add(view.key + " truth", view.truth_file, view.truths.front().channel);
        add(view.key + " noise", view.truth_file, view.truths.front().se_channel);
        add(view.key + " mask", view.truth_file, "mask.Y");
        add(view.key + " depth", view.gbuffer_file, "Z");
    }
    for (const CellRecord& cell : results.cells) {
        if (!cell.error.empty()) continue;
        add(cell.id + " output", cell.image_file, "Y");
        if (cell.filter != "none") add(cell.id + " raw", cell.image_file, "raw.Y");
    }
    return list;
}

std::vector<std::string> specs() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(AOSCORE_BROWSER_SPECS)) {
        const std::string name = entry.path().filename().string();
        const std::size_t at = name.find(".spec.mjs");
        if (at != std::string::npos) names.push_back(name.substr(0, at));
    }
    std::sort(names.begin(), names.end());
    return names;
}

class BrowserSpec : public ::testing::TestWithParam<std::string> {};

TEST_P(BrowserSpec, Holds) {
    if (const std::string missing = what_is_missing(); !missing.empty()) {
        const char* ci = std::getenv("CI");
        if (ci != nullptr && std::string(ci) == "true") FAIL() << missing << " is not there";
        GTEST_SKIP() << missing << " is not there";
    }
    const fs::path folder = testing::output_dir();
    const testing::ProgramRun run = testing::run_aoscore(
        "score atrium --methods alchemy,hbao,ssao --size 160x96 --samples 64 --quiet --out measured", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path measured = folder / "measured", synthetic = folder / "synthetic";
    write_atomically(folder / "values.json", exr_values(read_results(measured), measured).dump());
    testing::write_synthetic(testing::synthetic_results(), synthetic);
    write_report(synthetic);

    const std::string command =
        fmt::format("AOSCORE_TEST_FOLDER='{}' AOSCORE_HOME='{}' timeout 300 node '{}/{}.spec.mjs' >'{}' 2>&1",
                    folder.string(), home_dir().string(), AOSCORE_BROWSER_SPECS, GetParam(),
                    (folder / "spec.log").string());
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << read_file(folder / "spec.log");
}

INSTANTIATE_TEST_SUITE_P(Page, BrowserSpec, ::testing::ValuesIn(specs()), [](const auto& name) {
    std::string text = name.param;
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
});

}  // namespace
}  // namespace aoscore
