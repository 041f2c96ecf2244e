#include "results/export/export_files.h"

#include "core/files.h"

namespace aoscore {

namespace fs = std::filesystem;

ExportFiles::ExportFiles(const std::vector<fs::path>& paths) {
    for (const fs::path& path : paths) export_format(path);
    for (const fs::path& path : paths) {
        files_.push_back({path, PendingFile(path), &export_format(path)});
        fill_file(files_.back().pending.temporary(), "", path);
    }
}

void ExportFiles::write(const ExportTable& table) {
    for (const File& file : files_) fill_file(file.pending.temporary(), file.format->write(table), file.path);
    for (File& file : files_) file.pending.publish();
    files_.clear();
}

}  // namespace aoscore
