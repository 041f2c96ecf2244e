#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// How a command ended.
struct CommandEnd {
    bool timed_out = false;
    int exit_code = 0;
    int signal = 0;    ///< the signal that ended it; 0 where it ended by itself
    std::string said;  ///< the end of what it printed, on both streams

    bool ok() const { return !timed_out && exit_code == 0 && signal == 0; }
};

/// Runs a program, found on the PATH, with these arguments in `folder`; no shell reads them. It gets no
/// input. It and all that it starts are one group of processes, which is ended (asked first, killed two
/// seconds later) when the time is over, when Ctrl-C is pressed, and when the program itself has ended.
/// Throws file_error where it cannot be started, interrupted_error on Ctrl-C.
CommandEnd run_bounded(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       double seconds);

}  // namespace aoscore
