#pragma once

#include "results/export/export_format.h"

#include <filesystem>
#include <vector>

namespace aoscore {

/// Files to be written when the work is done, opened before it begins: an unknown format or a path that
/// cannot be written fails at once. What is there already stays until write().
class ExportFiles {
  public:
    /// Throws usage_error for an extension without a format, file_error for a path that cannot be written.
    explicit ExportFiles(const std::vector<std::filesystem::path>& paths);
    ~ExportFiles();
    ExportFiles(const ExportFiles&) = delete;
    ExportFiles& operator=(const ExportFiles&) = delete;

    bool empty() const { return files_.empty(); }
    /// Once. Throws file_error.
    void write(const ExportTable& table);

  private:
    void clear();

    struct File {
        std::filesystem::path path, temporary;
        const ExportFormat* format;
    };
    std::vector<File> files_;
};

}  // namespace aoscore
