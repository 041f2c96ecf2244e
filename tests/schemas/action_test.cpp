// The image and the action that a repository gates its pull requests with. Neither Docker nor GitHub is here:
// linters read the files, and the step that measures runs with a stand-in for docker that starts the program
// itself.
#include "core/files.h"
#include "core/processes/shell.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_shell;
using testing::ShellRun;
using testing::source_dir;

/// A linter of node_modules, or of the system's path.
ShellRun lint(const std::string& words) {
    return run_shell("cd " + shell_quoted(source_dir().string()) + " && PATH=node_modules/.bin:$PATH " +
                     words);
}

TEST(Linters, FindNothingInTheImageTheActionAndTheScripts) {
    for (const char* words :
         {"dockerfile-utils lint Dockerfile", "action-validator action.yml",
          "shellcheck run.sh test.sh .ci/run .ci/setup.sh cluster/gate.sh cluster/slurm.sh"}) {
        const ShellRun run = lint(words);
        EXPECT_EQ(run.status, 0) << words << "\n" << run.text;
    }
}

TEST(Linters, RefuseAnImageAndAnActionThatAreWrong) {
    const fs::path folder = output_dir();
    write_atomically(folder / "Dockerfile", "FROM debian:bookworm-slim\nRUNS true\n");
    EXPECT_NE(lint("dockerfile-utils lint " + shell_quoted((folder / "Dockerfile").string())).status, 0);
    std::string action = read_file(source_dir() / "action.yml");
    action.replace(action.find("composite"), 9, "composed");
    write_atomically(folder / "action.yml", action);
    EXPECT_NE(lint("action-validator " + shell_quoted((folder / "action.yml").string())).status, 0);
}

/// Stands in for docker: `run` starts the program with the folders of the machine in place of those of the
/// image.
constexpr const char* kStandIn = R"(#!/usr/bin/env bash
set -u
[ "$1" = run ] || exit 125
shift
work= cache= report=
while [ "$1" != aoscore ]; do
    case $1 in
        --volume)
            case ${2##*:} in
                /work) work=${2%:*} ;;
                /cache) cache=${2%:*} ;;
                /report) report=${2%:*} ;;
            esac
            shift ;;
        --user | --env) shift ;;
    esac
    shift
done
shift
cd "$work" && AOSCORE_CACHE=$cache exec "$PROGRAM" "${@/#\/report/$report}"
)";

/// What a step of a job sees: its folders, and the stand-in on its path.
class Job {
  public:
    explicit Job(fs::path folder) : folder_(std::move(folder)) {
        for (const char* sub : {"bin", "repository", "temp"}) fs::create_directories(folder_ / sub);
        write_atomically(folder_ / "bin" / "docker", kStandIn);
        fs::permissions(folder_ / "bin" / "docker", fs::perms::owner_all);
    }

    ShellRun measure(const std::string& arguments) const {
        const std::string here = folder_.string();
        return run_shell("env PROGRAM=" + shell_quoted(testing::program()) +
                         " PATH=" + shell_quoted(here + "/bin") + ":$PATH GITHUB_WORKSPACE=" +
                         shell_quoted(here + "/repository") + " RUNNER_TEMP=" + shell_quoted(here + "/temp") +
                         " GITHUB_STEP_SUMMARY=" + shell_quoted(here + "/summary.md") +
                         " ARGUMENTS=" + shell_quoted(arguments) + " " +
                         shell_quoted((source_dir() / "cluster" / "gate.sh").string()));
    }
    fs::path report() const { return folder_ / "temp" / "aoscore" / "report"; }
    std::string summary() const { return read_file(folder_ / "summary.md"); }
    const fs::path& folder() const { return folder_; }

  private:
    fs::path folder_;
};

constexpr const char* kScore = "score plane --view facing --size 48x32 --samples 4 --methods gtao --quiet";

TEST(Action, PassesAScoreWithinItsLimitAndKeepsPageAndTable) {
    const Job job(output_dir());
    const ShellRun run = job.measure(std::string(kScore) + " --fail 'rmse>0.9'");
    EXPECT_EQ(run.status, 0) << run.text;
    EXPECT_TRUE(fs::exists(job.report() / "results" / "index.html"));
    EXPECT_THAT(job.summary(), HasSubstr("gtao"));
    EXPECT_THAT(run.text, Not(HasSubstr("::error")));
}

TEST(Action, FailsAJobWhoseLimitIsTrippedAndKeepsThePage) {
    const Job job(output_dir());
    const ShellRun tripped = job.measure(std::string(kScore) + " --fail 'bias>-1'");
    EXPECT_EQ(WEXITSTATUS(tripped.status), 2) << tripped.text;
    EXPECT_THAT(tripped.text, HasSubstr("::error title=Ambient occlusion::a limit was tripped"));
    EXPECT_TRUE(fs::exists(job.report() / "results" / "index.html"));
}

TEST(Action, RunsNoCommandThatStandsInItsArguments) {
    const Job job(output_dir());
    const std::string mark = (job.folder() / "mark").string();
    for (const std::string& text :
         {"score $(touch " + mark + ")", "score `touch " + mark + "`", "list; touch " + mark})
        EXPECT_NE(job.measure(text).status, 0) << text;
    EXPECT_FALSE(fs::exists(mark));
}

TEST(Action, RefusesArgumentsThatAreEmptyOrLackAQuote) {
    const Job job(output_dir());
    for (const char* arguments : {"", "score 'plane"}) {
        const ShellRun run = job.measure(arguments);
        EXPECT_EQ(WEXITSTATUS(run.status), 64) << run.text;
        EXPECT_THAT(run.text, HasSubstr("::error title=aoscore::the input"));
    }
}

}  // namespace
}  // namespace aoscore
