#include "readme.h"

#include "core/files.h"

#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

namespace aoscore::testing {

namespace fs = std::filesystem;

std::string readme_commands(const std::string& heading) {
    std::istringstream lines(read_file(source_dir() / "README.md"));
    std::string line, commands;
    bool inside = false;
    while (std::getline(lines, line)) {
        if (line.starts_with("## ")) inside = line == "## " + heading;
        if (inside && line.starts_with("    ")) commands += line.substr(4) + "\n";
    }
    return commands;
}

ProgramRun run_readme_commands(const std::string& heading, const fs::path& folder,
                               const std::string& score_arguments) {
    write_atomically(folder / "commands.sh", "set -e\n" + readme_commands(heading));
    write_atomically(folder / "run.sh", "#!/bin/bash\nexport AOSCORE_CACHE='" +
                                            (folder / "truth-cache").string() +
                                            "'\nif [ \"$1\" = score ]; then set -- \"$@\" " +
                                            score_arguments + "; fi\nexec '" + program() + "' \"$@\"\n");
    fs::permissions(folder / "run.sh", fs::perms::owner_all);
    fs::create_directory_symlink(source_dir() / "shaders", folder / "shaders");
    const int status =
        std::system(("cd '" + folder.string() + "' && bash commands.sh >out.txt 2>err.txt").c_str());
    ProgramRun run;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = read_file(folder / "out.txt");
    run.err = read_file(folder / "err.txt");
    return run;
}

}  // namespace aoscore::testing
