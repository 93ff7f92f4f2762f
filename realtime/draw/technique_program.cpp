#include "realtime/draw/technique_program.h"

#include "realtime/technique/baked_family.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"

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
        std::set<std::string> all{"uClipFromRelative",
                                  "uEye",
                                  "uDepthPlane",
                                  "uDepthRange",
                                  "uLights",
                                  "uColor",
                                  "uHasColorMap",
                                  "uColorMap",
                                  "uObjectId",
                                  "uHeightMap",
                                  "uHeightMapClamps",
                                  "uReliefDepthWorld",
                                  "uShadowBias",
                                  "uShadowMaps",
                                  "uShadowPlaceFromRelative",
                                  "uShadowMap",
                                  "uShadowRounding",
                                  "uShadowMapBias"};
        for (const BakedFamily& family : bakedFamilies()) {
            all.insert(family.sampler);
            if (family.scaleUniform) all.insert(family.scaleUniform);
        }
        return all;
    }();
    return names;
}

/// Adds the code that writes a pixel's channels.
void addShading(ShaderSource& fragment, size_t lightCount) {
    fragment.addText("(lights)", lightDeclarations(lightCount));
    fragment.addFile(shaderFile("camera.glsl"));
    fragment.addFile(shaderFile("shading.glsl"));
    fragment.addFile(shaderFile("shadow_map.glsl"));
}

/// Adds everything for tracing a fragment's ray except search and surface.
void addRelief(ShaderSource& fragment, const Technique& technique) {
    fragment.addFile(shaderFile("height_map.glsl"));
    fragment.addFile(shaderFile("relief_contract.glsl"));
    fragment.addFile(shaderFile("relief_walk.glsl"));
    for (const std::string& kind : technique.bakedKinds())
        fragment.addFile(shaderFile(bakedFamily(kind).shader));
    fragment.addFile(shaderFile("relief_frame.glsl"));
    fragment.addFile(shaderFile("relief_hit.glsl"));
}

void addTechnique(ShaderSource& fragment, const Technique& technique) {
    if (technique.hasCurvedBase()) fragment.addFile(shaderFile("quadric_base.glsl"));
    fragment.addText("(parameters)", technique.glslConstants());
    fragment.addFile(technique.surface->shaderFile());
    fragment.addFile(technique.search.shaderFile());
}

std::string reliefSettings(const Technique& technique) {
    return fmt::format("const bool kHardwareFilter = {};\nconst bool kReliefShadows = {};\n"
                       "const bool kShadowMaps = {};\nconst bool kTriangleBounds = {};\n"
                       "const bool kDepthCorrection = {};\n",
                       technique.hardwareFilter(), technique.castsReliefShadows(),
                       technique.readsShadowMaps(), technique.discardsOutsideTriangle(),
                       technique.correctsDepth());
}

/// Builds a program that may declare the shadow maps' sampler and sets its unit. All samplers start at unit
/// 0, and samplers of different types on the same unit make a draw fail even if they aren't used.
std::unique_ptr<GlProgram> buildReceiver(const StageSources& sources) {
    auto program = std::make_unique<GlProgram>(sources.vertex, sources.fragment);
    program->use();
    glUniform1i(program->uniform("uShadowMaps"), unitBehindBaked());
    return program;
}

/// Whether `search` uses a function that `harness` defines. This checks the text because the compiler may
/// eliminate lookups that are unused with the current settings.
bool callsFunctionOf(const std::filesystem::path& search, const std::filesystem::path& harness) {
    const std::string text = readWholeFile(harness), searchText = readWholeFile(search);
    const std::regex definition("(?:^|\\n)[a-z]\\w* (\\w+)\\(");
    for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
        if (namesIdentifier(searchText, (*match)[1])) return true;
    return false;
}

} // namespace

StageSources plainSources(size_t lightCount, bool shadowMaps) {
    StageSources sources;
    sources.vertex.addFile(shaderFile("plain_vertex.glsl"));
    sources.fragment.addText("(settings)", fmt::format("const bool kShadowMaps = {};\n", shadowMaps));
    addShading(sources.fragment, lightCount);
    sources.fragment.addFile(shaderFile("plain_main.glsl"));
    return sources;
}

StageSources reliefSources(const Technique& technique, size_t lightCount) {
    StageSources sources;
    sources.vertex.addFile(shaderFile("proxy_vertex.glsl"));
    sources.fragment.addText("(settings)", reliefSettings(technique));
    addShading(sources.fragment, lightCount);
    addRelief(sources.fragment, technique);
    sources.fragment.addFile(shaderFile("relief_main.glsl"));
    addTechnique(sources.fragment, technique);
    return sources;
}

StageSources plainLightSources() {
    StageSources sources;
    sources.vertex.addFile(shaderFile("plain_vertex.glsl"));
    sources.fragment.addFile(shaderFile("camera.glsl"));
    sources.fragment.addFile(shaderFile("shadow_depth.glsl"));
    sources.fragment.addFile(shaderFile("shadow_plain_main.glsl"));
    return sources;
}

StageSources reliefLightSources(const Technique& technique) {
    StageSources sources;
    sources.vertex.addFile(shaderFile("proxy_vertex.glsl"));
    sources.fragment.addText("(settings)", reliefSettings(technique));
    sources.fragment.addFile(shaderFile("camera.glsl"));
    sources.fragment.addFile(shaderFile("shadow_depth.glsl"));
    addRelief(sources.fragment, technique);
    sources.fragment.addFile(shaderFile("shadow_relief_main.glsl"));
    addTechnique(sources.fragment, technique);
    return sources;
}

std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount) {
    const std::string author = technique.search.shaderFile().string();
    if (!namesIdentifier(readWholeFile(technique.search.shaderFile()), "traceRelief"))
        throw InputError(author, "doesn't define traceRelief", "ReliefHit traceRelief(ReliefRay ray) { … }");
    auto program = buildReceiver(reliefSources(technique, lightCount));
    const std::set<std::string> active = program->activeUniforms();
    for (const std::string& name : active)
        if (!harnessUniforms().contains(name))
            throw InputError(author,
                             fmt::format("declares uniform '{}', which the harness doesn't set", name),
                             "parameters in technique.toml");
    for (const std::string& kind : technique.bakedKinds())
        if (!callsFunctionOf(technique.search.shaderFile(), shaderFile(bakedFamily(kind).shader)))
            throw InputError(technique.search.file.string(),
                             fmt::format("declares input '{}', which the shader never reads", kind),
                             fmt::format("a shader that calls a function of {}", bakedFamily(kind).shader));
    return program;
}

std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps) {
    return buildReceiver(plainSources(lightCount, shadowMaps));
}

std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique) {
    const StageSources sources = reliefLightSources(technique);
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

std::unique_ptr<GlProgram> buildPlainLightProgram() {
    const StageSources sources = plainLightSources();
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

} // namespace plumbline
