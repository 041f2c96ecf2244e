#include "core/output.h"

#include "core/error.h"
#include "core/printable.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace aoscore {
namespace {

[[noreturn]] void fail(int error) {
    throw file_error("cannot be written: " + std::generic_category().message(error != 0 ? error : EIO),
                     "standard output");
}

void write(const std::string& bytes) {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) fail(errno);
}

}  // namespace

void write_output(std::string_view text) {
    write(printable_lines(text));
}

void print_path(const std::filesystem::path& path) {
    write((isatty(STDOUT_FILENO) != 0 ? printable(path.string()) : path.string()) + "\n");
}

void flush_output() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail(errno);
}

}  // namespace aoscore
