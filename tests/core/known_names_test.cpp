#include "core/known_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aoscore {
namespace {

const std::vector<std::string> kMethods = {"alchemy",   "gtao", "hbao",
                                           "hbao-plus", "ssao", "visibility-bitmask"};

TEST(KnownNames, TheNearestIsMeant) {
    EXPECT_EQ(meant_name("gtoa", kMethods), "gtao") << "swapped letters are one mistake";
    EXPECT_EQ(meant_name("GTAO", kMethods), "gtao");
    EXPECT_EQ(meant_name("alchmey", kMethods), "alchemy");
    EXPECT_EQ(meant_name("hbaoplus", kMethods), "hbao-plus");
    EXPECT_EQ(meant_name("hbap", kMethods), "hbao");
}

TEST(KnownNames, ABeginningOrAPartThatOnlyOneHasIsMeant) {
    EXPECT_EQ(meant_name("visi", kMethods), "visibility-bitmask");
    EXPECT_EQ(meant_name("bitmask", kMethods), "visibility-bitmask");
    EXPECT_EQ(meant_name("ao", kMethods), std::nullopt) << "four have it";
}

TEST(KnownNames, FarNamesAreNotMeant) {
    for (const char* name : {"nonsense", "", "x", "radiosity"})
        EXPECT_EQ(meant_name(name, kMethods), std::nullopt) << name;
    EXPECT_EQ(meant_name("gtao", {}), std::nullopt);
}

TEST(KnownNames, TheErrorAsksAndListsWhatIsKnown) {
    const Error error = unknown_name("no method", "gtoa", kMethods, "--methods");
    EXPECT_EQ(error.exit_code(), ExitCode::usage);
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("--methods: no method \"gtoa\"; did you mean gtao? (valid: alchemy,"));
    EXPECT_THAT(unknown_name("no method", "nonsense", kMethods).what(),
                ::testing::Not(::testing::HasSubstr("did you mean")));
}

TEST(KnownNames, ARowIsFoundByItsIdOrTheErrorListsAllIds) {
    struct Row {
        const char* id;
        int value;
    };
    const std::vector<Row> table{{"gtao", 1}, {"hbao", 2}};
    EXPECT_EQ(find_row(table, "hbao")->value, 2);
    EXPECT_EQ(find_row(table, "hba"), nullptr);
    EXPECT_EQ(row_of(table, "gtao", "no method").value, 1);
    try {
        row_of(table, "gtoa", "no method", "--methods");
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::usage);
        EXPECT_STREQ(e.what(), "--methods: no method \"gtoa\"; did you mean gtao? (valid: gtao, hbao)");
    }
    try {
        row_in_file(table, "gtoa", "claims.json: method");
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        EXPECT_STREQ(e.what(), "claims.json: method: is gtoa; did you mean gtao? (valid: gtao, hbao)");
    }
}

}  // namespace
}  // namespace aoscore
