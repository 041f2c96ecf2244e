#include "browser/browser_support.h"

#include "core/files.h"
#include "core/folders.h"
#include "image/image_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace aoscore::testing {

namespace fs = std::filesystem;

namespace {

/// Writes one channel as raw float32 and returns what a spec needs to find it.
nlohmann::json dumped(const fs::path& exr, const std::string& channel, const fs::path& to) {
    const ImageFile file = read_image(exr);
    const ImageF* image = file.channel(channel);
    if (image == nullptr) throw std::runtime_error(exr.string() + " lacks " + channel);
    write_atomically(to, std::string_view(reinterpret_cast<const char*>(image->pixels.data()),
                                          image->pixels.size() * sizeof(float)));
    return {{"file", to.string()}, {"width", image->width}, {"height", image->height}};
}

// This is less than CTest's limit, so that the log is still shown.
constexpr int kLongestSpec_s = 540;
constexpr int kTimedOut = 124;  // the exit code of timeout

}  // namespace

std::string missing_for_browser() {
    for (const char* program : {"chromium", "node"}) {
        if (std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) != 0) return program;
    }
    const fs::path packages = data_dir() / "node_modules";
    for (const char* package : {"playwright-core", "axe-core", "html-validate"}) {
        if (!fs::exists(packages / package))
            return (packages / package).string() + " (./test.sh installs it)";
    }
    return "";
}

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
        for (const CauseRecord& cause : view.causes)
            add(view.key + " " + cause.id, view.truth_file, cause.channel);
        add(view.key + " one_layer", view.truth_file, view.one_layer_channel);
    }
    for (const CellRecord& cell : results.cells) {
        if (!cell.error.empty()) continue;
        add(cell.id + " output", cell.image_file, "Y");
        if (cell.filter != "none") add(cell.id + " raw", cell.image_file, "raw.Y");
    }
    return list;
}

void expect_spec_holds(const std::string& script, const fs::path& folder) {
    const std::string command = fmt::format(
        "AOSCORE_TEST_FOLDER='{}' AOSCORE_DATA='{}' timeout {} node '{}/{}' >'{}' 2>&1", folder.string(),
        data_dir().string(), kLongestSpec_s, AOSCORE_BROWSER_SPECS, script, (folder / "spec.log").string());
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << (WIFEXITED(status) && WEXITSTATUS(status) == kTimedOut
                ? fmt::format("stopped after {} s, in the test after the last one named:\n", kLongestSpec_s)
                : "")
        << read_file(folder / "spec.log");
}

}  // namespace aoscore::testing
