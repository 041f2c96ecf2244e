#include "cli/arguments.h"
#include "cli/program.h"
#include "core/error.h"
#include "core/log.h"
#include "core/output.h"
#include "core/processes/shell.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <string>
#include <system_error>

namespace aoscore {
namespace {

std::string command_line(int argc, char** argv) {
    std::string line = "aoscore";
    for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
    return line;
}

/// Opens substitutes for closed standard streams: the first file that is opened would get the stream's
/// number, and printed text would go into that file. Writing to a substitute fails, as to a closed stream.
void hold_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != descriptor)
            throw internal_error("a standard stream is closed, and nothing can stand in for it");
    }
}

}  // namespace
}  // namespace aoscore

int main(int argc, char** argv) {
    using aoscore::ExitCode;
    ExitCode code = ExitCode::internal;
    try {
        aoscore::hold_standard_streams();
        code = aoscore::run_words(aoscore::arguments(argc, argv), aoscore::command_line(argc, argv));
        aoscore::flush_output();
    } catch (const aoscore::Error& e) {
        aoscore::log_error(fmt::format("aoscore: {}", e.what()));
        code = e.exit_code();
    } catch (const std::bad_alloc&) {
        aoscore::log_error("aoscore: not enough memory");
    } catch (const std::filesystem::filesystem_error& e) {
        aoscore::log_error(fmt::format("aoscore: {}: {}", e.path1().string(), e.code().message()));
        code = ExitCode::file_error;
    } catch (const std::system_error& e) {
        const bool exhausted =
            e.code() == std::errc::resource_unavailable_try_again || e.code() == std::errc::not_enough_memory;
        aoscore::log_error(fmt::format(
            "aoscore: {}{}", exhausted ? "not enough memory or threads: " : "internal error: ", e.what()));
    } catch (const std::exception& e) {
        aoscore::log_error(fmt::format("aoscore: internal error: {}", e.what()));
    }
    return static_cast<int>(code);
}
