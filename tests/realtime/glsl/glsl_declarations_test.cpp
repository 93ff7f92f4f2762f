#include "realtime/glsl/glsl_declarations.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(FileScopeNames, FunctionsAndPrototypes_AreNamedOnceWithoutParametersAndLocals) {
    EXPECT_THAT(
        fileScopeNames("float height(vec2 st);\n"
                       "float height(vec2 st) { float low = 1.0; return low * st.x; }\n"
                       "Ray enter(const in Ray a, out float b[2]) { for (int i = 0; i < 2; ++i) {} }\n"
                       "void main() {}"),
        ElementsAre("enter", "height"));
}

TEST(FileScopeNames, Variables_AreNamedWhateverTheirQualifiersAndValues) {
    EXPECT_THAT(fileScopeNames("uniform sampler2D uMap;\n"
                               "layout(location = 0) out vec4 outColor;\n"
                               "flat in ivec2 vCell, vOther[3];\n"
                               "const float kA = f(b, c), kB = kA * 1e-4, kC[2] = float[2](d, e);\n"
                               "const Pair kD = { g, { h } };\n"
                               "int gCount;\n"),
                ElementsAre("gCount", "kA", "kB", "kC", "kD", "outColor", "uMap", "vCell", "vOther"));
}

TEST(FileScopeNames, StructureMembers_AreNotAtFileScope) {
    EXPECT_THAT(fileScopeNames("struct Ray { vec2 st; float t[2]; };\n"
                               "struct Hit { bool hit; } gLast, gFirst;"),
                ElementsAre("Hit", "Ray", "gFirst", "gLast"));
}

TEST(FileScopeNames, BlockMembers_AreAtFileScopeWithoutAnInstanceName) {
    EXPECT_THAT(fileScopeNames("layout(std140) uniform Lights { vec4 place; float range, bias; };"),
                ElementsAre("Lights", "bias", "place", "range"));
    EXPECT_THAT(fileScopeNames("uniform Lights { vec4 place; } lights[2];"), ElementsAre("Lights", "lights"));
}

TEST(FileScopeNames, Directives_NameMacrosAndNothingElse) {
    EXPECT_THAT(fileScopeNames("#version 410 core\n#line 1000001\n"
                               "#define ONCE\n  #  define TWICE(x) ((x) + \\\n  (y))\n"
                               "#if ONCE\nint a;\n#else\nint b;\n#endif"),
                ElementsAre("ONCE", "TWICE", "a", "b"));
}

TEST(FileScopeNames, CommentsAndPrecision_NameNothing) {
    EXPECT_THAT(fileScopeNames("// int a;\n/* int b;\n{ */ precision highp float;\n"), IsEmpty());
    EXPECT_THAT(fileScopeNames(""), IsEmpty());
    EXPECT_THAT(fileScopeNames("int /* b */ c; // d"), ElementsAre("c"));
}

TEST(FileScopeNames, TextThatDoesNotCompile_Returns) {
    for (const char* text : {"{", "}", ")(", "struct", "struct {", "int", "= ;", "#define", "#", "int a = {;",
                             "#define A \\", "f() {", ";;,", "uniform { int a; };", "{};"})
        fileScopeNames(text);
}

} // namespace
} // namespace plumbline
