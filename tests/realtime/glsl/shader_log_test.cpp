// Compiler logs as Mesa 22.3, NVIDIA 535 and ANGLE write them.
#include "realtime/glsl/shader_log.h"
#include "realtime/glsl/shader_source.h"
#include "scenes/core/error.h"
#include "tests/errors.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

const std::vector<std::string> kFiles{"(preamble)", "harness.glsl", "mine.glsl"};

TEST(ShaderLog, EachDriversFormat_GivesFileAndLine) {
    for (const char* log :
         {"0:2000012(3): error: `x' undeclared\n", "0(2000012) : error C1503: `x' undeclared\r\n",
          "ERROR: 0:2000012: `x' undeclared\n"}) {
        const auto error = locateFirstError(log, kFiles);
        ASSERT_TRUE(error) << log;
        EXPECT_EQ(error->where, "mine.glsl:12");
        EXPECT_EQ(error->what, "`x' undeclared");
    }
}

TEST(ShaderLog, WarningsAndFurtherErrors_AreSkippedAndCounted) {
    const auto error = locateFirstError(
        "0:1000001(1): warning: w\n0:2000003(1): error: a\n0:2000004(1): error: b\n0:2000005(1): error: c\n",
        kFiles);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->where, "mine.glsl:3");
    EXPECT_EQ(error->what, "a (and 2 more errors)");
    EXPECT_FALSE(locateFirstError("0:1000001(1): warning: w\n", kFiles));
}

TEST(ShaderLog, UnknownFormat_IsShownUnchanged) {
    EXPECT_FALSE(locateFirstError("Fragment shader failed\n\n  at line twelve", kFiles));
    EXPECT_EQ(flattenLog("Fragment  shader\n\n failed \n"), "Fragment shader failed");
    EXPECT_EQ(flattenLog(""), "the driver gives no reason");
    EXPECT_LT(flattenLog(std::string(100000, 'x')).size(), 700u);
    EXPECT_FALSE(locateFirstError("0:" + std::string(100000, '1') + "(3): error: x", kFiles));
}

TEST(ShaderSource, Pieces_KeepNameAndLines) {
    ShaderSource source;
    source.addText("(a)", "one\ntwo");
    source.addText("(b)", "three");
    EXPECT_EQ(source.assemble("410 core", "p"),
              "#version 410 core\np\n#line 1000001\none\ntwo\n#line 2000001\nthree\n");
    EXPECT_EQ(source.files()[1], "(a)");
    EXPECT_EQ(source.author(), "(b)");
}

TEST(ShaderSource, MissingFile_IsInputError) {
    ShaderSource source;
    EXPECT_EQ(messageOf<InputError>([&] { source.addFile("/no/such.glsl"); }), "/no/such.glsl: no such file");
    EXPECT_EQ(messageOf<InputError>([&] { source.addFile("/tmp"); }),
              "/tmp: is not a file, it is a folder; expected a regular file");
}

} // namespace
} // namespace plumbline
