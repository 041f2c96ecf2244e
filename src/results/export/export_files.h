#pragma once

#include "core/pending_file.h"
#include "results/export/export_format.h"

#include <filesystem>
#include <vector>

namespace aoscore {

/// Export files, opened before the work begins and written after it: an unknown format or a path that cannot
/// be written fails at once. Existing files stay as they are until write().
class ExportFiles {
  public:
    /// Throws usage_error for an extension without a format, file_error for a path that cannot be written.
    explicit ExportFiles(const std::vector<std::filesystem::path>& paths);

    bool empty() const { return files_.empty(); }
    /// Writes all files; call it once. Throws file_error.
    void write(const ExportTable& table);

  private:
    struct File {
        std::filesystem::path path;
        PendingFile pending;
        const ExportFormat* format;
    };
    std::vector<File> files_;
};

}  // namespace aoscore
