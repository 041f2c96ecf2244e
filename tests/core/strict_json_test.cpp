#include "core/strict_json.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        return e.what();
    }
    return "";
}

TEST(StrictJson, UnreadKeyIsAnErrorThatNamesItsPlaceAndTheKnownKeys) {
    const json file = {{"near", 1}, {"naer", 2}};
    StrictObject object(file, "views.json: views[0]");
    object.number("near", 0, 10);
    const std::string message = message_of([&] { object.finish(); });
    EXPECT_THAT(message, HasSubstr("views.json: views[0].naer"));
    EXPECT_THAT(message, HasSubstr("near"));
}

TEST(StrictJson, ThePlaceOfAFilesOwnMembersFollowsItsName) {
    const json file = {{"label", 1}, {"pass", {{"scale", 0}}}};
    StrictObject top = StrictObject::of_file(file, "method.json");
    EXPECT_EQ(message_of([&] { top.text("label"); }), "method.json: label: is number (valid: a text)");
    StrictObject pass = top.object("pass");
    EXPECT_THAT(message_of([&] { pass.text("scale"); }), HasSubstr("method.json: pass.scale: "));
}

TEST(StrictJson, ValueOutOfRangeNamesTheRange) {
    const json file = {{"near", -1}};
    StrictObject object(file, "f");
    EXPECT_THAT(message_of([&] { object.number("near", 0, 10); }), HasSubstr("0 to 10"));
}

TEST(StrictJson, WrongTypesAndMissingMembersAreErrors) {
    const json file = {{"a", "text"}, {"b", 1.5}, {"c", json::array({1, 2})}};
    StrictObject object(file, "f");
    EXPECT_THAT(message_of([&] { object.number("a", 0, 1); }), HasSubstr("f.a"));
    EXPECT_THAT(message_of([&] { object.integer("b", 0, 9); }), HasSubstr("whole number"));
    EXPECT_THAT(message_of([&] { object.numbers("c", 3); }), HasSubstr("3 numbers"));
    EXPECT_THAT(message_of([&] { object.text("d"); }), HasSubstr("missing"));
}

}  // namespace
}  // namespace aoscore
