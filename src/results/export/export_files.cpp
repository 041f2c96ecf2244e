#include "results/export/export_files.h"

#include "core/error.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

void fill(const fs::path& temporary, const std::string& content, const fs::path& path) {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!out.flush()) throw file_error("cannot be written", path.string());
}

}  // namespace

ExportFiles::ExportFiles(const std::vector<fs::path>& paths) {
    for (const fs::path& path : paths) export_format(path);
    for (const fs::path& path : paths) {
        if (fs::is_directory(path)) throw file_error("is a folder", path.string(), "a file to write");
        const fs::path temporary = path.parent_path() / fmt::format(".{}.{}-{}.tmp", path.filename().string(),
                                                                    getpid(), files_.size());
        // Kept before it is opened, so that whatever fails, it is cleared away.
        files_.push_back({path, temporary, &export_format(path)});
        try {
            fill(temporary, "", path);
        } catch (...) {
            clear();
            throw;
        }
    }
}

ExportFiles::~ExportFiles() {
    clear();
}

void ExportFiles::clear() {
    std::error_code ec;
    for (const File& file : files_) fs::remove(file.temporary, ec);
    files_.clear();
}

void ExportFiles::write(const ExportTable& table) {
    for (const File& file : files_) fill(file.temporary, file.format->write(table), file.path);
    for (const File& file : files_) {
        std::error_code ec;
        fs::rename(file.temporary, file.path, ec);
        if (ec) throw file_error("cannot be written: " + ec.message(), file.path.string());
    }
}

}  // namespace aoscore
