// The shaders are in the common subset of GLSL 4.1 and GLSL ES 3.0, according to the reference compiler.
#include "realtime/technique/composition.h"
#include "realtime/technique/stage_sources.h"
#include "realtime/technique/technique_list.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>

namespace plumbline {
namespace {

bool haveValidator() {
    return std::system("glslangValidator --version >/dev/null 2>&1") == 0;
}

/// Writes the validator's inputs to `folder`, as GLSL 4.1 and as GLSL ES 3.0. File names end in the stage.
void addShaders(const TemporaryFolder& folder, const std::string& name, const StageSources& sources) {
    const char* preamble = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                           "precision highp sampler2DArray;";
    for (const auto& [stage, source] :
         {std::pair(".vert", sources.vertex), std::pair(".frag", sources.fragment)}) {
        writeFile(folder / (name + " core" + stage), source.assemble());
        writeFile(folder / (name + " ES" + stage), source.assemble("300 es", preamble));
    }
}

/// One run for all files, because starting the validator takes longer than compiling a shader. Its output
/// names the files.
std::string validatorOutput(const TemporaryFolder& folder) {
    const std::string command =
        "cd '" + folder.path().string() + "' && glslangValidator *.vert *.frag >log 2>&1";
    return std::system(command.c_str()) == 0 ? "" : readFile(folder / "log");
}

TEST(PortableGlsl, EveryTechnique_IsGlsl410AndGlslEs300) {
    if (!haveValidator()) GTEST_SKIP() << "glslangValidator isn't installed (package glslang-tools)";
    const TemporaryFolder folder;
    size_t programs = 0;
    const auto check = [&](const StageSources& sources, const std::string& name) {
        ++programs;
        addShaders(folder, name, sources);
    };
    // ES 3.0 guarantees only four draw buffers.
    for (const size_t lights : {0u, 1u, 3u}) {
        for (const bool shadowMaps : {false, true})
            check(plainSources(lights, shadowMaps),
                  fmt::format("plain, shadow maps {}, lights {}", shadowMaps, lights));
        for (const Manifest& info : listTechniques())
            for (const std::string& surface : surfacesFor(info, listSurfaces()))
                for (const char* shadow : {"", "map"}) {
                    const std::map<std::string, std::string> settings =
                        *shadow ? std::map<std::string, std::string>{{"shadow", shadow}}
                                : std::map<std::string, std::string>{};
                    check(reliefSources(resolveTechnique({info.name, surface, settings}, {}), lights),
                          fmt::format("{}@{} shadow={}, lights {}", info.name, surface, shadow, lights));
                }
    }
    check(plainLightSources(), "plain, light pass");
    for (const Manifest& info : listTechniques())
        for (const std::string& surface : surfacesFor(info, listSurfaces()))
            check(reliefLightSources(resolveTechnique({info.name, surface, {}}, {})),
                  info.name + "@" + surface + ", light pass");
    EXPECT_GE(programs, 3u * 5u);
    EXPECT_EQ(folder.fileCount(), 4 * programs); // program names are unique
    EXPECT_EQ(validatorOutput(folder), "");
}

} // namespace
} // namespace plumbline
