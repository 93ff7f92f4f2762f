// The shaders stay in the common subset of GLSL 4.1 and GLSL ES 3.0, by the reference compiler's judgement.
#include "realtime/draw/technique_program.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/technique_list.h"
#include "tests/realtime/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

namespace plumbline {
namespace {

bool haveValidator() {
    return std::system("glslangValidator --version >/dev/null 2>&1") == 0;
}

/// Output of the validator, empty if it is content.
std::string validate(const TemporaryFolder& folder, const ShaderSource& source, const char* stage, bool es) {
    const char* preamble = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                           "precision highp sampler2DArray;";
    const std::string text = es ? source.assemble("300 es", preamble) : source.assemble();
    const std::string name = std::string("shader.") + stage;
    folder.write(name, text);
    const std::string command =
        "cd " + folder.path().string() + " && glslangValidator " + name + " >log 2>&1";
    if (std::system(command.c_str()) == 0) return {};
    std::ifstream log(folder.path() / "log");
    return {std::istreambuf_iterator<char>(log), {}};
}

TEST(PortableGlsl, EveryTechniqueIsGlsl410AndGlslEs300) {
    if (!haveValidator()) GTEST_SKIP() << "glslangValidator isn't installed (package glslang-tools)";
    const TemporaryFolder folder;
    int programs = 0;
    const auto check = [&](const StageSources& sources, const std::string& name) {
        ++programs;
        for (const bool es : {false, true}) {
            EXPECT_EQ(validate(folder, sources.vertex, "vert", es), "") << name << (es ? " ES" : " core");
            EXPECT_EQ(validate(folder, sources.fragment, "frag", es), "") << name << (es ? " ES" : " core");
        }
    };
    // ES 3.0 promises four draw buffers only; with more lights the outputs go on as they do here.
    for (const size_t lights : {0u, 1u, 3u}) {
        for (const bool shadowMaps : {false, true})
            check(plainSources(lights, shadowMaps), "plain");
        for (const Manifest& info : listTechniques())
            for (const std::string& surface : surfacesFor(info, listSurfaces()))
                for (const char* shadow : {"", "map"}) {
                    const std::map<std::string, std::string> settings =
                        *shadow ? std::map<std::string, std::string>{{"shadow", shadow}}
                                : std::map<std::string, std::string>{};
                    check(reliefSources(resolveTechnique({info.name, surface, settings}, {}), lights),
                          info.name + "@" + surface + " shadow=" + shadow);
                }
    }
    check(plainLightSources(), "plain, light pass");
    for (const Manifest& info : listTechniques())
        for (const std::string& surface : surfacesFor(info, listSurfaces()))
            check(reliefLightSources(resolveTechnique({info.name, surface, {}}, {})),
                  info.name + "@" + surface + ", light pass");
    EXPECT_GE(programs, 3 * 5);
}

} // namespace
} // namespace plumbline
