#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// A program started beside this one, whose standard output is read here. It gets no input, its standard
/// error goes nowhere, and no open file but these three. It is killed when this object ends.
class ChildProcess {
  public:
    /// Throws internal_error when it cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// At most `size` bytes of its output; 0 at its end. Throws interrupted_error() once Ctrl-C was pressed.
    std::size_t read(void* to, std::size_t size);

    struct End {
        int exit_code = 0;
        int signal = 0;  ///< the signal that ended it; 0 where it ended by itself
    };
    /// Waits until it ends. Call once, after all of its output was read.
    End wait();

  private:
    pid_t pid_ = -1;
    int output_ = -1;
};

}  // namespace aoscore
