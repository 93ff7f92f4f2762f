#include "realtime/draw/technique_program.h"

#include "realtime/glsl/glsl_declarations.h"
#include "realtime/glsl/glsl_text.h"
#include "realtime/glsl/shader_source.h"
#include "realtime/technique/baked_family.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plumbline {
namespace {

/// Builds a program that may declare the shadow maps' sampler and sets its unit. All samplers start at unit
/// 0, and samplers of different types on the same unit make a draw fail even if they aren't used.
std::unique_ptr<GlProgram> buildReceiver(const StageSources& sources) {
    auto program = std::make_unique<GlProgram>(sources.vertex, sources.fragment);
    program->use();
    glUniform1i(program->uniform("uShadowMaps"), unitBehindBaked());
    return program;
}

/// Whether the shader `search` uses what the file `harness` declares. Its text decides: a compiler drops a
/// lookup whose result some setting makes worthless.
bool usesDeclarationOf(const std::filesystem::path& search, const std::filesystem::path& harness) {
    const std::string searchText = readShader(search);
    return std::ranges::any_of(fileScopeNames(readShader(harness)),
                               [&](const std::string& name) { return namesIdentifier(searchText, name); });
}

/// Throws InputError for a uniform in use that the harness doesn't declare, and so never sets.
void checkUniforms(const GlProgram& program, const StageSources& sources, const std::string& author) {
    const std::set<std::string> inVertexStage = fileScopeNames(sources.vertex.assemble());
    for (const std::string& name : program.activeUniforms())
        if (!harnessNames().contains(name) && !inVertexStage.contains(name))
            throw InputError(author,
                             fmt::format("declares uniform '{}', which the harness doesn't set", name),
                             "parameters in technique.toml");
}

} // namespace

std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount, Side side) {
    const std::string author = technique.search.shaderFile().string();
    if (!namesIdentifier(readShader(technique.search.shaderFile()), "traceRelief"))
        throw InputError(author, "doesn't define traceRelief", "ReliefHit traceRelief(ReliefRay ray) { … }");
    const StageSources sources = reliefSources(technique, lightCount, side);
    auto program = buildReceiver(sources);
    checkUniforms(*program, sources, author);
    for (const std::string& kind : technique.bakedKinds())
        if (!usesDeclarationOf(technique.search.shaderFile(), harnessShader(bakedFamily(kind).shader)))
            throw InputError(technique.search.file.string(),
                             fmt::format("declares input '{}', which the shader never reads", kind),
                             fmt::format("a shader that calls a function of {}", bakedFamily(kind).shader));
    return program;
}

std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps) {
    return buildReceiver(plainSources(lightCount, shadowMaps));
}

std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique, Side side) {
    const StageSources sources = reliefLightSources(technique, side);
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

std::unique_ptr<GlProgram> buildPlainLightProgram() {
    const StageSources sources = plainLightSources();
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

std::unique_ptr<GlProgram> buildNearestPolygonProgram() {
    const StageSources sources = nearestPolygonSources();
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

} // namespace plumbline
