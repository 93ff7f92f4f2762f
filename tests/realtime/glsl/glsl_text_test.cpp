#include "realtime/glsl/glsl_text.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(GlslWord, KeywordsTypesAndFunctions_AreTheLanguages) {
    for (const char* word :
         {"float", "row_major", "vec3", "hvec2", "mat2x4", "samplerCube", "isampler2DArray", "imageBuffer",
          "smoothstep", "textureLod", "dFdx", "roundEven", "main"})
        EXPECT_TRUE(isGlslWord(word)) << word;
    for (const char* word : {"steps", "vector", "vec", "sampler", "material", "imagery", "Float", ""})
        EXPECT_FALSE(isGlslWord(word)) << word;
}

TEST(WithoutComments, Lines_KeepTheirNumbers) {
    EXPECT_EQ(withoutComments("a // b\nc /* d\ne */ f"), "a     \nc     \n     f");
    EXPECT_EQ(withoutComments("a /* b"), "a     ");
}

TEST(NamesIdentifier, OnlyWholeWordsOutsideComments_Count) {
    EXPECT_TRUE(namesIdentifier("x = steps;", "steps"));
    EXPECT_FALSE(namesIdentifier("x = substeps + steps2; // steps", "steps"));
}

TEST(NonAsciiByte, InCode_IsFoundWithItsLine) {
    EXPECT_FALSE(firstNonAsciiByte("int a; // \xc3\xa4\n"));
    const auto byte = firstNonAsciiByte("/*\n\n*/\nint \xc3\xa4;");
    ASSERT_TRUE(byte);
    EXPECT_EQ(byte->line, 4);
    EXPECT_EQ(byte->value, 0xc3);
}

} // namespace
} // namespace plumbline
