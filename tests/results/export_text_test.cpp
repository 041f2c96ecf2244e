// Tests names of any characters in exports.
#include "results/export/csv_line.h"
#include "results/export/export_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <set>
#include <sstream>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ExportText, ACsvFieldIsNoFormulaAndANumberStaysOne) {
    EXPECT_EQ(csv_line({"=1+1", "+cmd", "-x", "@sum", "\tx"}), "'=1+1,'+cmd,'-x,'@sum,'\tx\r\n");
    EXPECT_EQ(csv_line({"=HYPERLINK(\"a\",1)"}), "\"'=HYPERLINK(\"\"a\"\",1)\"\r\n");
    EXPECT_EQ(csv_line({"-0.5", "-1e-9", "-inf", "x=1", "a-b", ""}), "-0.5,-1e-9,-inf,x=1,a-b,\r\n");
}

/// The places at which a separator stands in a line, in characters.
std::vector<std::size_t> places_of(char separator, const std::string& line) {
    std::vector<std::size_t> places;
    std::size_t at = 0;
    for (const char c : line) {
        if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;
        if (c == separator) places.push_back(at);
        ++at;
    }
    return places;
}

TEST(ExportText, ForReadersIsAlignedAndWithoutEmptyColumnsAndTheRole) {
    ExportTable table;
    table.name_columns = {"view", "rank", "role", "setting"};
    table.columns = {{"rmse", "RMSE"}, {"beyond", "Beyond one layer"}, {"all_digits", "", 4, false}};
    table.rows.push_back({"a", {"atrium/wide", "4–5", "method", ""}, {0.5, {}, 1.0}, {}, "", {}});
    table.rows.push_back({"b", {"hall", "bound", "bound", ""}, {-12.25, {}, 2.0}, {}, "", {}});
    for (const auto& [text, separator] :
         {std::pair{export_as::markdown(table), '|'}, std::pair{export_as::latex(table), '&'}}) {
        std::istringstream lines(text);
        std::set<std::vector<std::size_t>> places;
        for (std::string line; std::getline(lines, line);) {
            if (line.find(separator) != std::string::npos) places.insert(places_of(separator, line));
        }
        EXPECT_EQ(places.size(), 1U) << text;
        for (const char* gone : {"role", "method", "setting", "Beyond", "all_digits"})
            EXPECT_THAT(text, Not(HasSubstr(gone)));
        for (const char* there : {"atrium/wide", "4–5", "0.5000", "12.2500", "RMSE"})
            EXPECT_THAT(text, HasSubstr(there));
    }
    table.rows[1].numbers[1] = 0.25;
    EXPECT_THAT(export_as::markdown(table), HasSubstr("Beyond one layer"));
}

TEST(ExportText, OfEveryFormatHoldsNoCharacterThatIsNone) {
    ExportTable table;
    table.title = "a\uFFFEtitle";
    table.name_columns = {"truth", "test"};
    table.columns = {{"rmse", "RMSE"}};
    const std::string hostile = "b\u202E\u2028\x01\xFF";
    table.text_columns = {"lengths"};
    table.rows.push_back({hostile, {"a\uFFFE", hostile}, {0.5}, {hostile}, "broken\uFFFF", {"tripped\x1b"}});
    for (const ExportFormat& format : export_formats()) {
        if (format.extension == ".json") continue;  // it writes the caller's document
        const std::string text = format.write(table);
        for (const char* bad : {"\uFFFE", "\u202E", "\u2028", "\x01", "\xFF", "\uFFFF", "\x1b"})
            EXPECT_THAT(text, Not(HasSubstr(bad))) << format.label;
        EXPECT_THAT(text, HasSubstr("b\uFFFD")) << format.label;
    }
    pugi::xml_document xml;
    EXPECT_TRUE(xml.load_string(export_as::junit(table).c_str()));
}

}  // namespace
}  // namespace aoscore
