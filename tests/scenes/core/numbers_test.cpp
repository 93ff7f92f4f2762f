#include "scenes/core/numbers.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(ParseNumber, WholeTextsThatAreNumbers_AreRead) {
    EXPECT_EQ(parseNumber<double>("-0.25"), -0.25);
    EXPECT_EQ(parseNumber<double>("1e-3"), 0.001);
    EXPECT_EQ(parseNumber<double>(std::string_view("12,5").substr(0, 2)), 12);
    EXPECT_EQ(parseNumber<int>("-7"), -7);
    EXPECT_EQ(parseNumber<unsigned>("7"), 7u);
}

TEST(ParseNumber, AnyOtherText_IsNothing) {
    for (const char* text : {"", " 1", "1 ", "+1", "1,5", "1x", "x", "0x10", "1e999", "inf", "-inf", "nan"})
        EXPECT_EQ(parseNumber<double>(text), std::nullopt) << text;
    for (const char* text : {"", "1.0", "1e2", "99999999999", "one"})
        EXPECT_EQ(parseNumber<int>(text), std::nullopt) << text;
    EXPECT_EQ(parseNumber<unsigned>("-1"), std::nullopt);
}

TEST(ParseSignedNumber, OnePlus_IsTaken) {
    EXPECT_EQ(parseSignedNumber<double>("+0.5"), 0.5);
    EXPECT_EQ(parseSignedNumber<double>("-0.5"), -0.5);
    EXPECT_EQ(parseSignedNumber<int>("7"), 7);
    for (const char* text : {"+", "+-1", "-+1", "++1", "--1", "+ 1", ""})
        EXPECT_EQ(parseSignedNumber<double>(text), std::nullopt) << text;
}

} // namespace
} // namespace plumbline
