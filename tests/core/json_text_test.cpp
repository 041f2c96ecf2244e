// Tests JSON of other programs.
#include "core/json_text.h"

#include "core/error.h"
#include "core/files.h"
#include "core/strict_json.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string refusal_of(const std::string& text) {
    const auto path = testing::output_dir() / "file.json";
    write_atomically(path, text);
    try {
        parse_json_file(path);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        return e.what();
    }
    return "no error";
}

TEST(JsonText, ANumberThatNoDoubleHoldsIsAnErrorAtItsPlace) {
    EXPECT_THAT(refusal_of("{\"a\": 1,\n \"b\": 1e999}"),
                HasSubstr("file.json: line 2, column 7 of the JSON: is a number"));
    EXPECT_THAT(refusal_of("{\"b\": -1e999}"), HasSubstr("no double holds"));
}

TEST(JsonText, ASyntaxErrorNamesItsPlaceAndQuotesNothing) {
    const std::string refusal = refusal_of("{\"a\": 1,\n root:x:0:0}");
    EXPECT_THAT(refusal, HasSubstr("file.json: line 2, column 2 of the JSON: is not JSON"));
    EXPECT_THAT(refusal, ::testing::Not(HasSubstr("root")));
}

TEST(JsonText, NestingThatWouldOverflowAStackIsRefused) {
    EXPECT_THAT(refusal_of("{\"a\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}"),
                HasSubstr("nested deeper"));
}

TEST(JsonText, BytesThatAreNoUtf8AreWrittenAsTheReplacementCharacter) {
    EXPECT_EQ(json_text({{"name", "a\xFF"}}), "{\"name\":\"a\xEF\xBF\xBD\"}");
}

TEST(JsonText, MessagesQuoteShortValuesAlone) {
    EXPECT_EQ(quoted_json(1.5), "1.5");
    EXPECT_EQ(quoted_json(json::array({1})), "array");
    EXPECT_EQ(quoted_json(std::string(1000, 'x')), "a long string");
}

}  // namespace
}  // namespace aoscore
