#include "core/files.h"
#include "report/report.h"
#include "report/synthetic_results.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

/// The page in headless Chromium: the document after its script has run, for several addresses. A machine
/// without Chromium skips these tests and says so; with CI=true they fail there.
namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

bool have_chromium() {
    return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

#define REQUIRE_CHROMIUM()                                                                     \
    if (!have_chromium()) {                                                                    \
        const char* ci = std::getenv("CI");                                                    \
        if (ci != nullptr && std::string(ci) == "true") FAIL() << "chromium is not installed"; \
        GTEST_SKIP() << "chromium is not installed";                                           \
    }                                                                                          \
    static_assert(true)

class Browser : public ::testing::Test {
  protected:
    void SetUp() override {
        REQUIRE_CHROMIUM();
        folder_ = testing::output_dir();
        testing::write_synthetic(testing::synthetic_results(), folder_);
        page_ = write_report(folder_);
    }

    /// The document at the page's address with this fragment, after load; `steps` is script run after the
    /// page's.
    std::string document(const std::string& fragment, const std::string& steps = {}) {
        fs::path page = page_;
        if (!steps.empty()) {
            page = folder_ / "driven.html";
            write_atomically(page, read_file(page_) + "<script>" + steps + "</script>");
        }
        const fs::path out = folder_ / "document.html", profile = folder_ / "profile";
        const std::string command =
            "timeout 100 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
            "--disable-background-networking --disable-component-update --disable-sync --user-data-dir='" +
            profile.string() + "' --virtual-time-budget=4000 --window-size=1600,1200 --dump-dom 'file://" +
            page.string() + fragment + "' >'" + out.string() + "' 2>'" + (folder_ / "chromium.log").string() +
            "'";
        const int status = std::system(command.c_str());
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "chromium ended with " << status;
        fs::remove_all(profile);
        return read_file(out);
    }

    /// The opening tag of the document's root, where the page's script keeps its state.
    static std::string state(const std::string& html) {
        const std::size_t at = html.find("<html");
        return at == std::string::npos ? "" : html.substr(at, html.find('>', at) - at);
    }

    static void expect_no_script_error(const std::string& html) {
        EXPECT_THAT(state(html), HasSubstr("data-ready=\"true\""));
        EXPECT_THAT(state(html), Not(HasSubstr("data-script-error")));
    }

  private:
    fs::path folder_, page_;
};

TEST_F(Browser, OpensOnTheClosestMethodWithoutScriptErrors) {
    const std::string html = document("");
    expect_no_script_error(html);
    EXPECT_THAT(state(html), HasSubstr("data-view=\"atrium/wide\""));
    EXPECT_THAT(state(html), HasSubstr("data-shown=\"error atrium/wide/alchemy/performance-wide\""));
}

TEST_F(Browser, ShowsWhatItsAddressNames) {
    const std::string html = document(
        "#view=atrium/close&cell=atrium/close/hbao-hussain/"
        "performance-close&kind=masks&compare=swipe&cut=30");
    expect_no_script_error(html);
    EXPECT_THAT(state(html), HasSubstr("data-shown=\"masks atrium/close/hbao-hussain/performance-close\""));
    EXPECT_THAT(state(html), HasSubstr("data-compare=\"swipe\""));
    EXPECT_THAT(html, HasSubstr("--cut: 30%"));
}

TEST_F(Browser, IgnoresAnAddressThatNamesNothing) {
    const std::string html = document("#view=nowhere&cell=%22%3E%3Cscript%3E&kind=no&compare=no&cut=x");
    expect_no_script_error(html);
    EXPECT_THAT(state(html), HasSubstr("data-view=\"atrium/wide\""));
}

TEST_F(Browser, ChoosesByRadioAndByKey) {
    const std::string html = document("", R"js(
        const box = document.querySelector('.stage-layout');
        box.scrollIntoView({behavior: 'instant'});
        const radio = [...document.querySelectorAll('input[name=kind]')].find((input) => input.value === 'raw');
        radio.click();
        dispatchEvent(new KeyboardEvent('keydown', {key: '3'}));
        document.documentElement.dataset.after3 = document.documentElement.dataset.shown;
        dispatchEvent(new KeyboardEvent('keydown', {key: 't'}));
        document.documentElement.dataset.during = document.documentElement.dataset.held +
            document.querySelectorAll('figure.over').length;
        dispatchEvent(new KeyboardEvent('keyup', {key: 't'}));
        document.documentElement.dataset.afterwards = document.documentElement.dataset.held +
            document.querySelectorAll('figure.over').length;
        dispatchEvent(new KeyboardEvent('keydown', {key: 'f'}));
        document.documentElement.dataset.actual = document.querySelectorAll('.figures.actual').length;
    )js");
    expect_no_script_error(html);
    EXPECT_THAT(state(html), HasSubstr("data-after3=\"raw atrium/wide/hbao-hussain/performance-wide\""));
    EXPECT_THAT(state(html), HasSubstr("data-during=\"true1\""));
    EXPECT_THAT(state(html), HasSubstr("data-afterwards=\"false0\""));
    EXPECT_THAT(state(html), HasSubstr("data-actual=\"1\""));
}

TEST_F(Browser, SortsTheRankingByAHeadAndKeepsFailedRowsLast) {
    const std::string html = document("", R"js(
        const table = document.querySelectorAll('#ranking table')[1];
        const heads = [...table.tHead.rows[0].cells];
        const button = heads.find((head) => head.textContent.startsWith('Fetches')).querySelector('button');
        const order = () => [...table.tBodies[0].rows].map((row) => row.dataset.cell.split('/')[2]).join(' ');
        table.addEventListener('sort-end', () => {
            const steps = document.documentElement.dataset;
            if (steps.up) { steps.down = order(); } else { steps.up = order(); button.click(); }
        });
        button.click();
    )js");
    expect_no_script_error(html);
    EXPECT_THAT(state(html), HasSubstr("data-up=\"crytek-ssao hbao-hussain alchemy\""));
    EXPECT_THAT(state(html), HasSubstr("data-down=\"hbao-hussain crytek-ssao alchemy\""));
}

TEST_F(Browser, DecodesEveryPictureAtItsStatedSize) {
    const std::string html = document("", R"js(
        const images = [...document.querySelectorAll('.stage img')];
        Promise.all(images.map((image) => { image.loading = 'eager'; return image.decode(); })).then(() => {
            const wrong = images.filter((image) => image.naturalWidth !== Number(image.getAttribute('width')) ||
                image.naturalHeight !== Number(image.getAttribute('height')));
            document.documentElement.dataset.decoded = `${images.length - wrong.length} of ${images.length}`;
        }).catch((error) => { document.documentElement.dataset.scriptError = String(error); });
    )js");
    expect_no_script_error(html);
    // Two views with truth, noise and depth; 5 filtered cells with four pictures, 3 unfiltered with three.
    EXPECT_THAT(state(html), HasSubstr("data-decoded=\"35 of 35\""));
}

}  // namespace
}  // namespace aoscore
