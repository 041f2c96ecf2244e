// Tests names of any characters in exports.
#include "results/export/csv_line.h"
#include "results/export/export_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ExportText, ACsvFieldIsNoFormulaAndANumberStaysOne) {
    EXPECT_EQ(csv_line({"=1+1", "+cmd", "-x", "@sum", "\tx"}), "'=1+1,'+cmd,'-x,'@sum,'\tx\r\n");
    EXPECT_EQ(csv_line({"=HYPERLINK(\"a\",1)"}), "\"'=HYPERLINK(\"\"a\"\",1)\"\r\n");
    EXPECT_EQ(csv_line({"-0.5", "-1e-9", "-inf", "x=1", "a-b", ""}), "-0.5,-1e-9,-inf,x=1,a-b,\r\n");
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
