#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore::testing {

/// The results of methods where the value is known: rows of scene, method, the source of the value, both
/// values.
class FidelityTable {
  public:
    /// Adds a row, and expects `read` within `tolerance` of `expected`.
    void add(const std::string& scene, const std::string& method, const std::string& source, double read,
             double expected, double tolerance);
    /// Writes the table as Markdown.
    void write(const std::filesystem::path& file) const;

  private:
    std::vector<std::string> rows_;
};

}  // namespace aoscore::testing
