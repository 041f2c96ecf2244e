#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore::testing {

/// What methods read where the value is known: rows of scene, method, the source of the value, both values.
class FidelityTable {
  public:
    /// Also expects `read` within `tolerance` of `expected`.
    void add(const std::string& scene, const std::string& method, const std::string& source, double read,
             double expected, double tolerance);
    /// As Markdown.
    void write(const std::filesystem::path& file) const;

  private:
    std::vector<std::string> rows_;
};

}  // namespace aoscore::testing
