// Text of unknown origin must not hide, move or reverse neighbouring text.
#include "engine/core/visible.h"

#include <gtest/gtest.h>

#include "engine/core/texts.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

TEST(Visible, LeavesOrdinaryTextOfAnyScriptAlone)
{
    for (const char* text : {"", "shaft.xyz", "wał żółty Ø50", "12\u202F345", "シャフト", "مرحبا", "😀"})
        EXPECT_EQ(visible(text), text);
}

TEST(Visible, ShowsWhatTurnsTextRoundOrHides)
{
    EXPECT_EQ(visible("part\u202Egpj.xyz"), "part<U+202E>gpj.xyz");
    EXPECT_EQ(visible("\u2066a\u2069"), "<U+2066>a<U+2069>");
    EXPECT_EQ(visible("a\u200Bb\uFEFF"), "a<U+200B>b<U+FEFF>");
    EXPECT_EQ(visible("\x1b[2Jx\x7f"), "<U+001B>[2Jx<U+007F>");
    EXPECT_EQ(visible("\u009B2J"), "<U+009B>2J");  // a terminal command in one character
}

TEST(Visible, KeepsLinesWhereTheyAreMeant)
{
    EXPECT_EQ(visible("a\nb\tc"), "a<U+000A>b<U+0009>c");
    EXPECT_EQ(visible("a\nb\tc\r", true), "a\nb\tc<U+000D>");
}

TEST(Visible, ShowsBytesThatAreNoUtf8)
{
    EXPECT_EQ(visible("a\x9b"
                      "2J"),
              "a<9B>2J");
    EXPECT_EQ(visible("\xC0\xAF"), "<C0><AF>");          // overlong
    EXPECT_EQ(visible("\xED\xA0\x80"), "<ED><A0><80>");  // surrogate
    EXPECT_EQ(visible("\xF4\x90\x80\x80"), "<F4><90><80><80>");
    EXPECT_EQ(visible("\xE2\x82"), "<E2><82>");
}

TEST(Visible, IsAppliedToNamesInMessages)
{
    const Error error(errors::fileNotFound, {{"path", std::string("a\x1b]0;b\x07")}});
    EXPECT_EQ(text(error), "a<U+001B>]0;b<U+0007>: This file does not exist.");
}

}  // namespace
TEST(Visible, CodePointsThatAreNoCharactersAreShown)
{
    EXPECT_EQ(visible("a\uFFFFb"), "a<U+FFFF>b");
    EXPECT_EQ(visible("\uFDD0"), "<U+FDD0>");
    EXPECT_EQ(visible("\U0001FFFE"), "<U+1FFFE>");
    EXPECT_EQ(visible("\uFFFD"), "\uFFFD");
}

}  // namespace lathelier
