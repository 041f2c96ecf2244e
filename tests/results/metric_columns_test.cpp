// Every metric, also one added later, is in every export with the words of its row.
#include "core/known_names.h"
#include "metrics/metric.h"
#include "results/export/export_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class MetricExport : public ::testing::Test {
  protected:
    MetricExport() {
        table_.name_columns = {"method"};
        add_measures(table_);
        MetricMap measured;
        for (const Metric& row : metrics()) measured[std::string(row.id)].value = 0.25;
        table_.rows.push_back({"m", {"m"}, measures_of(measured, std::nullopt), {}, "", {}});
    }
    const ExportColumn* column(const std::string& key) const {
        return find_row(table_.columns, key, &ExportColumn::key);
    }

    ExportTable table_;
};

TEST_F(MetricExport, HasAColumnForEachRowAndOneForEachEndOfItsInterval) {
    for (const Metric& row : metrics()) {
        const std::string id(row.id);
        ASSERT_NE(column(id), nullptr) << id;
        EXPECT_EQ(column(id)->brief, row.brief) << id;
        EXPECT_EQ(column(id)->decimals, row.decimals) << id;
        EXPECT_EQ(column(id)->label,
                  std::string(row.label) + (row.unit.empty() ? "" : " (" + std::string(row.unit) + ")"));
        for (const char* end : {"_low", "_high"})
            EXPECT_EQ(column(id + end) != nullptr, row.resampled != nullptr) << id << end;
    }
}

std::string without_padding(const std::string& text) {
    return std::regex_replace(text, std::regex(" +"), " ");
}

TEST_F(MetricExport, IsReadByItsIdInCsvAndByItsLabelInTablesForReaders) {
    const std::string csv = export_as::csv(table_), markdown = without_padding(export_as::markdown(table_)),
                      latex = without_padding(export_as::latex(table_));
    for (const Metric& row : metrics()) {
        EXPECT_THAT(csv, HasSubstr("," + std::string(row.id) + ","));
        const std::string cell = "| " + std::string(row.label) + " |", field = "& " + std::string(row.label);
        if (row.brief) {
            EXPECT_THAT(markdown, HasSubstr(cell));
            EXPECT_THAT(latex, HasSubstr(field));
        } else {
            EXPECT_THAT(markdown, Not(HasSubstr(cell)));
        }
    }
}

}  // namespace
}  // namespace aoscore
