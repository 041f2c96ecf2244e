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

void write(const std::string& bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) flush_output();
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
    const bool flushed = std::fflush(stdout) == 0;
    const int why = errno != 0 ? errno : EIO;
    if (!flushed || std::ferror(stdout) != 0)
        throw file_error("cannot be written: " + std::generic_category().message(why), "standard output");
}

}  // namespace aoscore
