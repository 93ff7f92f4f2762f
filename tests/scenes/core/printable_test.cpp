#include "scenes/core/printable.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace plumbline {
namespace {

TEST(Printable, TextOfAnyLanguage_StaysAsItIs) {
    for (const char* text : {"", "torus 1", "Größe", "岩 \U0001f5ff", "e\u0301", "\u00a0", "\ufffd"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, ActingCharacters_BecomeBlanks) {
    for (const char* acting :
         {"\x1b", "\n", "\r", "\t", "\x7f", "\u0080", "\u009b", "\u009f", "\u2028", "\u2029", "\u202a",
          "\u202e", "\u2066", "\u2069", "\u200e", "\u200f", "\u061c"})
        EXPECT_EQ(printable(fmt::format("a{}b", acting)), "a b") << acting;
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a b");
    EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), " [31mred [0m");
}

TEST(Printable, BytesThatAreNotUtf8_BecomeReplacementCharacters) {
    // C1 in Latin-1; a lead byte alone; overlong; a surrogate; beyond Unicode; cut off.
    EXPECT_EQ(printable("a\x9b"), "a\ufffd");
    EXPECT_EQ(printable("\xc3"), "\ufffd");
    EXPECT_EQ(printable("\xc0\x9b"), "\ufffd\ufffd");
    EXPECT_EQ(printable("\xe0\x80\x9b"), "\ufffd\ufffd\ufffd");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\ufffd\ufffd\ufffd");
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\ufffd\ufffd\ufffd\ufffd");
    EXPECT_EQ(printable("\xe2\x80x"), "\ufffd\ufffdx");
}

RC_GTEST_PROP(PrintableProperty, AnyBytes_BecomeHarmless, (const std::string& bytes)) {
    const std::string text = printable(bytes);
    RC_ASSERT(printable(text) == text);
    for (const char c : text)
        RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

} // namespace
} // namespace plumbline
