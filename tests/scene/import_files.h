#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace aoscore::testing {

/// Scene files of other programs, made in a test's own folder.
class ImportFolder {
  public:
    ImportFolder();

    const std::filesystem::path& path() const { return folder_; }
    /// Writes a file, below folders of its own where its name has any; returns its path.
    std::filesystem::path write(const std::string& name, std::string_view content) const;
    /// Writes texels as a PNG.
    void write_png(const std::string& name, const Image<glm::u8vec4>& texels) const;

    /// Writes the file and loads it as a scene.
    Scene load(const std::string& name, std::string_view content, const LoadOptions& options = {}) const;
    /// Its error, which must be a file_error of one line that names the file; empty when it loads.
    std::string refusal(const std::string& name, std::string_view content) const;

  private:
    std::filesystem::path folder_;
};

/// The area of all triangles.
double area_of(const Scene& scene);
/// All warnings in one text.
std::string warnings_of(const Scene& scene);

}  // namespace aoscore::testing
