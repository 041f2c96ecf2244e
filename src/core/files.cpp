#include "core/files.h"

#include "core/error.h"
#include "core/pending_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace aoscore {

namespace fs = std::filesystem;

std::string_view version() {
    return AOSCORE_VERSION;
}

std::string read_file(const fs::path& path, std::size_t max_bytes) {
    std::error_code ec;
    const fs::file_status status = fs::status(path, ec);
    if (!fs::exists(status)) throw file_error("no such file", path.string());
    if (!fs::is_regular_file(status)) throw file_error("not a regular file", path.string());
    const std::uintmax_t size = fs::file_size(path, ec);
    if (ec) throw file_error(ec.message(), path.string());
    if (size > max_bytes) {
        throw file_error(fmt::format("file of {} bytes is too large", size), path.string(),
                         fmt::format("at most {} bytes", max_bytes));
    }
    std::string content(static_cast<std::size_t>(size), '\0');
    std::ifstream in(path, std::ios::binary);
    if (!in.read(content.data(), static_cast<std::streamsize>(size)))
        throw file_error("cannot be read", path.string());
    return content;
}

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    std::error_code ec;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), ec);
    if (ec) throw file_error("folder cannot be made: " + ec.message(), path.parent_path().string());
    PendingFile file(path);
    write(file.temporary());
    file.publish();
}

void write_atomically(const fs::path& path, std::string_view content) {
    write_atomically(path, [&](const fs::path& temporary) { fill_file(temporary, content, path); });
}

void fill_file(const fs::path& file, std::string_view content, const fs::path& named) {
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!out.flush())
        throw file_error("cannot be written: " + std::generic_category().message(errno), named.string());
}

}  // namespace aoscore
