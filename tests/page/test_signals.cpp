// Tests the section of signals beside visibility.
#include "core/files.h"
#include "core/signal.h"
#include "image/image_file.h"
#include "metrics/signal_metric.h"
#include "page/page.h"
#include "page/pictures/signal_picture.h"
#include "support/support.h"
#include "synthetic_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace aoscore::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Adds to an image file these channels, the same value everywhere.
void add_channels(const std::filesystem::path& path, const std::vector<std::string_view>& names) {
    const ImageFile file = read_image(path);
    std::vector<ChannelView> channels;
    for (std::size_t i = 0; i < file.channels.size(); ++i)
        channels.push_back({file.channel_names[i], &file.channels[i]});
    const ImageF plane(file.channel("Y")->width, file.channel("Y")->height, 0.125F);
    for (const std::string_view name : names) channels.push_back({std::string(name), &plane});
    write_exr(path, channels, {});
}

std::string page_of(const std::filesystem::path& folder) {
    return read_file(write_page(folder));
}

TEST(SignalSection, IsLeftOutWhereNoneWasAskedFor) {
    const auto folder = output_dir();
    write_synthetic(synthetic_results(), folder);
    EXPECT_THAT(page_of(folder), Not(HasSubstr("id=\"signals\"")));
}

TEST(SignalSection, HasATableAndPicturesOfEverySignal) {
    const auto folder = output_dir();
    Results results = synthetic_results();
    ViewRecord& view = results.views.front();
    CellRecord& cell = results.cells.front();
    ASSERT_EQ(cell.view_key, view.key);
    for (const std::string& id : further_signals()) {
        view.signals.push_back({id, 0.25, 100});
        for (const SignalMetric& metric : signal_metrics()) {
            if (metric.signal == id) cell.signals[id][std::string(metric.id)] = {12.34, "a note"};
        }
    }
    write_synthetic(results, folder);
    for (const std::string& id : further_signals()) {
        const auto& channels = signal(id).channels;
        add_channels(folder / view.truth_file, {channels.begin(), channels.end()});
        add_channels(folder / cell.image_file, {channels.begin(), channels.end()});
    }
    EXPECT_THAT(page_of(folder), Not(HasSubstr("alt=\"Error of the")));
    for (const std::string& id : further_signals())
        add_channels(folder / view.truth_file, {signal(id).error_channel});
    const std::string page = page_of(folder);
    EXPECT_THAT(page, HasSubstr("id=\"signals\""));
    for (const std::string& id : further_signals()) {
        EXPECT_THAT(page, HasSubstr("alt=\"" + std::string(signal(id).label) + ": Truth on"));
        EXPECT_THAT(page, HasSubstr("alt=\"Error of the " + std::string(signal(id).label)));
    }
    for (const SignalMetric& metric : signal_metrics()) EXPECT_THAT(page, HasSubstr(metric.label));
    EXPECT_THAT(page, HasSubstr("title=\"a note\">12.34<"));
}

TEST(SignalSection, ReadsBackWhatTheResultsSay) {
    const auto folder = output_dir();
    Results results = synthetic_results();
    results.cells.front().signals["bent_normal"]["bent_angle_mean"] = {3.5, ""};
    results.views.front().signals = {{"bent_normal", 0.5, 7}};
    write_results(results, folder);
    const Results read = read_results(folder);
    EXPECT_EQ(read.cells.front().signals.at("bent_normal").at("bent_angle_mean").value, 3.5);
    EXPECT_EQ(read.views.front().signals.front().known_pixels, 7u);
}

}  // namespace
}  // namespace aoscore::testing
