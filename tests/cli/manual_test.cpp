// Manual pages and completions, which are made of the tables of options.
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

/// What a shell's command line prints, both streams together.
std::string printed(const std::string& command) {
    const testing::ShellRun run = testing::run_shell(command);
    return run.text + (run.status == 0 ? "" : "\n(failed)");
}

std::string script_for(const std::string& shell, const fs::path& folder) {
    const ProgramRun run = run_aoscore("completion " + shell, folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const fs::path path = folder / ("completion." + shell);
    std::ofstream(path) << run.out;
    return path.string();
}

/// A folder whose aoscore is the program under test, for scripts that start it by name.
std::string with_program(const fs::path& folder) {
    fs::create_directories(folder / "bin");
    if (!fs::exists(folder / "bin" / "aoscore")) {
        std::ofstream(folder / "bin" / "aoscore")
            << "#!/bin/sh\nexec '" << testing::program() << "' \"$@\"\n";
        fs::permissions(folder / "bin" / "aoscore", fs::perms::owner_all);
    }
    return "PATH='" + (folder / "bin").string() + "':$PATH ";
}

TEST(Manual, HasAPageForEveryCommandThatMandocTakes) {
    const fs::path folder = output_dir();
    const ProgramRun run = run_aoscore("manual --into pages", folder);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    std::size_t pages = 0;
    for (const auto& entry : fs::directory_iterator(folder / "pages")) {
        ++pages;
        const std::string errors = printed("mandoc -T lint -W error '" + entry.path().string() + "'");
        EXPECT_EQ(errors, "") << entry.path();
    }
    EXPECT_GT(pages, 10u);
    const std::string score =
        printed("mandoc -T ascii '" + (folder / "pages" / "aoscore-score.1").string() + "' | col -b");
    EXPECT_THAT(score,
                AllOf(HasSubstr("aoscore score"), HasSubstr("--score-error"), HasSubstr("EXIT STATUS")));
    EXPECT_EQ(run_aoscore("manual nonsense", folder).exit_code, 64);
}

std::string bash_words(const std::string& script, const std::vector<std::string>& line,
                       const fs::path& folder) {
    std::ostringstream words;
    for (const std::string& word : line) words << "'" << word << "' ";
    std::ofstream(folder / "complete.sh")
        << "source '" << script << "'\nCOMP_WORDS=(" << words.str() << ")\nCOMP_CWORD=" << line.size() - 1
        << "\n_aoscore 2>/dev/null\necho \"${COMPREPLY[*]}\"\n";
    return printed(with_program(folder) + "bash '" + (folder / "complete.sh").string() + "'");
}

TEST(Completion, OfBashGivesCommandsOptionsAndTheirValues) {
    const fs::path folder = output_dir();
    const std::string script = script_for("bash", folder);
    EXPECT_EQ(bash_words(script, {"aoscore", "sco"}, folder), "score\n");
    EXPECT_EQ(bash_words(script, {"aoscore", "score", "--si"}, folder), "--signals --size\n");
    EXPECT_EQ(bash_words(script, {"aoscore", "score", "atrium", "--border", ""}, folder), "far clamp\n");
    EXPECT_THAT(bash_words(script, {"aoscore", "score", "atrium", "--methods", "gt"}, folder),
                HasSubstr("gtao"));
    EXPECT_THAT(bash_words(script, {"aoscore", "score", "atr"}, folder), HasSubstr("atrium"));
}

TEST(Completion, OfFishGivesCommandsOptionsAndTheirValues) {
    const fs::path folder = output_dir();
    const std::string script = script_for("fish", folder);
    const auto words = [&](const std::string& line) {
        return printed("HOME='" + folder.string() + "' " + with_program(folder) + "fish -N -c \"source '" +
                       script + "'; complete -C '" + line + "'\"");
    };
    EXPECT_THAT(words("aoscore sco"), AllOf(HasSubstr("score"), Not(HasSubstr("sweep"))));
    EXPECT_THAT(words("aoscore score --si"), AllOf(HasSubstr("--size"), HasSubstr("--signals")));
    EXPECT_THAT(words("aoscore score atrium --border "), AllOf(HasSubstr("far"), HasSubstr("clamp")));
    EXPECT_THAT(words("aoscore score atrium --methods gt"), HasSubstr("gtao"));
}

// zsh completes at a terminal alone: this one is zsh's own, and a key has it write down what stands in its
// line.
TEST(Completion, OfZshGivesCommandsOptionsAndTheirValues) {
    const fs::path folder = output_dir();
    fs::rename(script_for("zsh", folder), folder / "_aoscore");
    const std::string shown = (folder / "completed").string();
    std::ofstream(folder / ".zshrc") << "PS1=\nfpath=('" << folder.string() << "' $fpath)\n"
                                     << "autoload -Uz compinit; compinit -D -u\nsetopt NO_BEEP\n"
                                     << "bindkey '^I' complete-word\n"
                                     << "show() { print -r -- \"<$BUFFER>\" >>'" << shown << "'; BUFFER= }\n"
                                     << "zle -N show\nbindkey '^G' show\n";
    std::ofstream(folder / "complete.zsh") << R"(
zmodload zsh/zpty
zpty -b shell "ZDOTDIR='$1' zsh -i"
count=0
for line in 'aoscore sco' 'aoscore score --siz' 'aoscore score atrium --border cla' 'aoscore score atrium --methods gta'; do
    (( ++count ))
    zpty -w -n shell "$line"$'\t\a'
    for n in {1..500}; do
        zpty -r -t shell part
        [[ -f $1/completed && $(wc -l <$1/completed) -ge $count ]] && break
        sleep 0.05
    done
done
zpty -d shell
)";
    printed(with_program(folder) + "timeout 120 zsh -f '" + (folder / "complete.zsh").string() + "' '" +
            folder.string() + "'");
    EXPECT_EQ(printed("cat '" + shown + "'"),
              "<aoscore score >\n<aoscore score --size >\n<aoscore score atrium --border clamp >\n"
              "<aoscore score atrium --methods gtao >\n");
}

}  // namespace
}  // namespace aoscore
