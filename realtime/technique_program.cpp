#include "technique_program.h"

#include "../scenes/data_folder.h"
#include "../scenes/error.h"
#include "baked_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

namespace plumbline {
namespace {

std::filesystem::path shaderFile(const char* name) {
    return dataFolder() / "realtime" / "shaders" / name;
}

std::string lightDeclarations(size_t lightCount) {
    return fmt::format("const int kLightCount = {};\nconst int kLightSlots = {};\n"
                       "uniform vec4 uLights[kLightSlots]; // to-light direction, 0; or position, 1\n",
                       lightCount, std::max<size_t>(lightCount, 1));
}

const std::set<std::string>& harnessUniforms() {
    static const std::set<std::string> names = [] {
        std::set<std::string> all{"uClipFromRelative", "uEye",       "uDepthPlane",      "uDepthRange",
                                  "uLights",           "uColor",     "uHasColorMap",     "uColorMap",
                                  "uObjectId",         "uHeightMap", "uHeightMapClamps", "uReliefDepthWorld",
                                  "uShadowBias"};
        for (const BakedFamily& family : bakedFamilies()) {
            all.insert(family.sampler);
            if (family.scaleUniform) all.insert(family.scaleUniform);
        }
        return all;
    }();
    return names;
}

void addHarness(ShaderSource& fragment, size_t lightCount) {
    fragment.addText("(lights)", lightDeclarations(lightCount));
    fragment.addFile(shaderFile("camera.glsl"));
    fragment.addFile(shaderFile("shading.glsl"));
}

/// Whether `search` names a function that `harness` defines. Asked of the text: a compiler drops a look-up whose result some
/// setting makes worthless.
bool callsFunctionOf(const std::filesystem::path& search, const std::filesystem::path& harness) {
    const std::string text = readText(harness), searchText = readText(search);
    const std::regex definition("(?:^|\\n)[a-z]\\w* (\\w+)\\(");
    for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
        if (namesIdentifier(searchText, (*match)[1])) return true;
    return false;
}

} // namespace

StageSources plainSources(size_t lightCount) {
    StageSources sources;
    sources.vertex.addFile(shaderFile("plain_vertex.glsl"));
    addHarness(sources.fragment, lightCount);
    sources.fragment.addFile(shaderFile("plain_main.glsl"));
    return sources;
}

StageSources reliefSources(const Technique& technique, size_t lightCount) {
    StageSources sources;
    sources.vertex.addFile(shaderFile("proxy_vertex.glsl"));
    sources.fragment.addText(
        "(settings)", fmt::format("const bool kHardwareFilter = {};\nconst bool kCastShadows = {};\n"
                                  "const bool kTriangleBounds = {};\nconst bool kDepthCorrection = {};\n",
                                  technique.hardwareFilter(), technique.castsShadows(),
                                  technique.discardsOutsideTriangle(), technique.correctsDepth()));
    addHarness(sources.fragment, lightCount);
    sources.fragment.addFile(shaderFile("height_map.glsl"));
    sources.fragment.addFile(shaderFile("relief_contract.glsl"));
    sources.fragment.addFile(shaderFile("relief_walk.glsl"));
    for (const std::string& kind : technique.bakedKinds())
        sources.fragment.addFile(shaderFile(bakedFamily(kind).shader));
    sources.fragment.addFile(shaderFile("relief_frame.glsl"));
    sources.fragment.addFile(shaderFile("relief_main.glsl"));
    if (technique.hasBentBase()) sources.fragment.addFile(shaderFile("quadric_base.glsl"));
    sources.fragment.addText("(parameters)", technique.glslConstants());
    sources.fragment.addFile(technique.surface->shaderFile());
    sources.fragment.addFile(technique.search.shaderFile());
    return sources;
}

std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount) {
    const std::string author = technique.search.shaderFile().string();
    if (!namesIdentifier(readText(technique.search.shaderFile()), "traceRelief"))
        throw InputError(author, "doesn't define traceRelief", "ReliefHit traceRelief(ReliefRay ray) { … }");
    const StageSources sources = reliefSources(technique, lightCount);
    auto program = std::make_unique<GlProgram>(sources.vertex, sources.fragment);
    const std::set<std::string> active = program->activeUniforms();
    for (const std::string& name : active)
        if (!harnessUniforms().contains(name))
            throw InputError(author,
                             fmt::format("declares uniform '{}', which the harness doesn't set", name),
                             "parameters in technique.toml");
    for (const std::string& kind : technique.bakedKinds())
        if (!callsFunctionOf(technique.search.shaderFile(), shaderFile(bakedFamily(kind).shader)))
            throw InputError(technique.search.file.string(),
                             fmt::format("asks for input '{}', which the shader never reads", kind),
                             fmt::format("a shader that calls a function of {}", bakedFamily(kind).shader));
    return program;
}

std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount) {
    const StageSources sources = plainSources(lightCount);
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

} // namespace plumbline
