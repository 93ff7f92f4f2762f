#include "scenes/core/error.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline {
namespace {

TEST(Error, AllParts_AreInOrder) {
    EXPECT_STREQ(InputError("scene.toml:3: width", "is 0", "1 to 32768", "did you mean 1?").what(),
                 "scene.toml:3: width: is 0; expected 1 to 32768; did you mean 1?");
    EXPECT_STREQ(InputError("a.obj", "no such file").what(), "a.obj: no such file");
    EXPECT_STREQ(MachineError("", "no OpenGL").what(), "no OpenGL");
}

TEST(Error, QuotedNewlines_StayOneLine) {
    EXPECT_STREQ(InputError("a\nb", "c\rd\te").what(), "a b: c d e");
}

TEST(Error, Typo_FindsNearestName) {
    const std::vector<std::string> names{"repeat", "clamp", "torus"};
    EXPECT_EQ(didYouMean("repaet", names), "did you mean 'repeat'?"); // two letters swapped: distance 1
    EXPECT_EQ(didYouMean("Torus", names), "did you mean 'torus'?");   // capitals don't count
    EXPECT_EQ(didYouMean("clmp", names), "did you mean 'clamp'?");
    EXPECT_EQ(didYouMean("sphere", names), ""); // "repeat" is 5 edits away, more than a third
    EXPECT_EQ(didYouMean("x", names), "");
    EXPECT_EQ(didYouMean("", names), "");
    EXPECT_EQ(didYouMean("torus", {}), "");
    EXPECT_EQ(didYouMean(std::string(1 << 20, 'a'), names), ""); // no quadratic search for a huge name
}

TEST(Error, SeveralNames_AreListed) {
    EXPECT_EQ(listOf(std::vector<std::string>{"a", "b", "c"}), "a, b or c");
    EXPECT_EQ(listOf(std::vector<std::string>{"a"}), "a");
    EXPECT_EQ(listOf({}), "");
}

} // namespace
} // namespace plumbline
