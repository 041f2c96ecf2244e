#include "fidelity_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace aoscore::testing {

void FidelityTable::add(const std::string& scene, const std::string& method, const std::string& source,
                        double read, double expected, double tolerance) {
    EXPECT_NEAR(read, expected, tolerance) << scene << ", " << method << ": " << source;
    rows_.push_back(fmt::format("| {} | {} | {} | {:.4f} | {:.4f} | {:+.4f} | {:g} |", scene, method, source,
                                read, expected, read - expected, tolerance));
}

void FidelityTable::write(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << "| scene | method | expected from | read | expected | difference | tolerance |\n"
           "|---|---|---|---|---|---|---|\n";
    for (const std::string& row : rows_) out << row << "\n";
    ASSERT_TRUE(out.flush()) << file;
}

}  // namespace aoscore::testing
