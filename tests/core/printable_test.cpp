// Text from outside, made fit for a line of a terminal, a log or a page.
#include "core/printable.h"

#include "core/error.h"
#include "core/processes/shell.h"

#include <gtest/gtest.h>

#include <string>

namespace aoscore {
namespace {

const std::string kShown = "\xEF\xBF\xBD";  // U+FFFD

TEST(Printable, TextOfAnyScriptStaysAsItIs) {
    for (const char* text : {"", "plain ~ text", "Grüße", "東京", "🙂", "שלום", "a\u200Db", "1 mm²"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, WhatHasNoPlaceOnALineBecomesTheReplacementCharacter) {
    for (const char* text :
         {"\n", "\x1b", "\x7f", "\u0085", "\u2028", "\u2029", "\u200E", "\u200F", "\u061C", "\u202A",
          "\u202E", "\u2066", "\u2069", "\uFFFE", "\uFFFF", "\uFDD0", "\U0001FFFE", "\U0010FFFF"}) {
        EXPECT_EQ(printable(std::string("a") + text + "b"), "a" + kShown + "b") << text;
    }
}

// The Unicode Standard 15.0, section 3.9: the examples of ill-formed sequences.
TEST(Printable, BytesThatAreNoUtf8AreReplacedOneByOne) {
    EXPECT_EQ(printable("\xFF"), kShown);
    EXPECT_EQ(printable("\xC0\xAF"), kShown + kShown) << "longer than it need be";
    EXPECT_EQ(printable("\xED\xA0\x80"), kShown + kShown + kShown) << "a surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), kShown + kShown + kShown + kShown) << "beyond U+10FFFF";
    EXPECT_EQ(printable("\xE2\x82"), kShown + kShown) << "cut short";
    EXPECT_EQ(printable("\xE2\x82z"), kShown + kShown + "z");
}

TEST(Printable, LinesKeepTheirBreaksAndTabs) {
    EXPECT_EQ(printable_lines("a\n\tb\r"), "a\n\tb" + kShown);
}

TEST(Printable, AnErrorNamesItsPlaceOnOneLineAndShowsSeveralOfAShader) {
    const Error error = file_error("shader:\n  > 3 | x", "a\nb\u202E.frag", "no\nbreak");
    EXPECT_EQ(std::string(error.what()),
              "a" + kShown + "b" + kShown + ".frag: shader:\n  > 3 | x (valid: no" + kShown + "break)");
}

TEST(Printable, ACommandIsQuotedSoThatItCanBeShownAndGivenAgain) {
    EXPECT_EQ(shell_quoted("plain.exr"), "plain.exr");
    EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_quoted("a\xFF'\n"), "$'a\\377\\047\\012'");
}

}  // namespace
}  // namespace aoscore
