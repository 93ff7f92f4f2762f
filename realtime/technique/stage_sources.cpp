#include "realtime/technique/stage_sources.h"

#include "realtime/glsl/glsl_declarations.h"
#include "realtime/technique/baked_family.h"
#include "scenes/core/data_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace plumbline {
namespace {

/// What of a technique decides the text of the harness.
struct HarnessUse {
    bool hardwareFilter = false, reliefShadows = false, shadowMaps = false, triangleBounds = false,
         depthCorrection = false;
    std::vector<std::string> bakedKinds;
    bool curvedBase = false, boundedDescent = false;
    Side side = Side::Front;
};

HarnessUse useBy(const Technique& technique, Side side) {
    return {technique.hardwareFilter(),
            technique.castsReliefShadows(),
            technique.readsShadowMaps(),
            technique.discardsOutsideTriangle(),
            technique.correctsDepth(),
            technique.bakedKinds(),
            technique.hasCurvedBase(),
            technique.surface->hasOffer("bounded_descent"),
            side};
}

/// A use of every file there is.
HarnessUse useOfAll() {
    HarnessUse use;
    use.curvedBase = use.boundedDescent = true;
    for (const BakedFamily& family : bakedFamilies())
        use.bakedKinds.emplace_back(family.kinds.front());
    return use;
}

std::string settingsText(const HarnessUse& use) {
    return fmt::format("const bool kHardwareFilter = {};\nconst bool kReliefShadows = {};\n"
                       "const bool kShadowMaps = {};\nconst bool kTriangleBounds = {};\n"
                       "const bool kDepthCorrection = {};\nconst bool kFromBehind = {};\n",
                       use.hardwareFilter, use.reliefShadows, use.shadowMaps, use.triangleBounds,
                       use.depthCorrection, use.side == Side::Back);
}

std::string lightDeclarations(size_t lightCount) {
    return fmt::format("const int kLightCount = {};\nconst int kLightSlots = {};\n"
                       "uniform vec4 uLights[kLightSlots]; // to-light direction, 0; or position, 1\n",
                       lightCount, std::max<size_t>(lightCount, 1));
}

/// What writes a pixel's channels.
void addShading(ShaderSource& fragment, size_t lightCount) {
    fragment.addText("(lights)", lightDeclarations(lightCount));
    fragment.addFile(harnessShader("camera.glsl"));
    fragment.addFile(harnessShader("shading.glsl"));
    fragment.addFile(harnessShader("shadow_map.glsl"));
}

/// What writes a depth alone.
void addLightPass(ShaderSource& fragment) {
    fragment.addFile(harnessShader("camera.glsl"));
    fragment.addFile(harnessShader("shadow_depth.glsl"));
}

/// The fragment stage in front of parameters, surface and search. `lightCount`: none in the light pass.
ShaderSource reliefHarness(const HarnessUse& use, std::optional<size_t> lightCount) {
    ShaderSource fragment;
    fragment.addText("(settings)", settingsText(use));
    if (lightCount)
        addShading(fragment, *lightCount);
    else
        addLightPass(fragment);
    fragment.addFile(harnessShader("height_map.glsl"));
    fragment.addFile(harnessShader("relief_contract.glsl"));
    fragment.addFile(harnessShader("relief_side.glsl"));
    if (use.boundedDescent) fragment.addFile(harnessShader("relief_descent.glsl"));
    fragment.addFile(harnessShader("relief_walk.glsl"));
    for (const std::string& kind : use.bakedKinds)
        fragment.addFile(harnessShader(bakedFamily(kind).shader));
    fragment.addFile(harnessShader("relief_frame.glsl"));
    fragment.addFile(harnessShader("relief_hit.glsl"));
    fragment.addFile(harnessShader(lightCount ? "relief_main.glsl" : "shadow_relief_main.glsl"));
    if (use.curvedBase) fragment.addFile(harnessShader("quadric_base.glsl"));
    return fragment;
}

StageSources reliefStages(const Technique& technique, Side side, std::optional<size_t> lightCount) {
    StageSources sources;
    sources.vertex.addFile(harnessShader("proxy_vertex.glsl"));
    sources.fragment = reliefHarness(useBy(technique, side), lightCount);
    sources.fragment.addText("(parameters)", technique.glslConstants());
    sources.fragment.addFile(technique.surface->shaderFile());
    sources.fragment.addFile(technique.search.shaderFile());
    return sources;
}

} // namespace

std::filesystem::path harnessShader(const std::string& name) {
    return dataFolder() / "realtime" / "shaders" / name;
}

StageSources plainSources(size_t lightCount, bool shadowMaps) {
    StageSources sources;
    sources.vertex.addFile(harnessShader("plain_vertex.glsl"));
    sources.fragment.addText("(settings)", fmt::format("const bool kShadowMaps = {};\n", shadowMaps));
    addShading(sources.fragment, lightCount);
    sources.fragment.addFile(harnessShader("plain_main.glsl"));
    return sources;
}

StageSources reliefSources(const Technique& technique, size_t lightCount, Side side) {
    return reliefStages(technique, side, lightCount);
}

StageSources plainLightSources() {
    StageSources sources;
    sources.vertex.addFile(harnessShader("plain_vertex.glsl"));
    addLightPass(sources.fragment);
    sources.fragment.addFile(harnessShader("shadow_plain_main.glsl"));
    return sources;
}

StageSources nearestPolygonSources() {
    StageSources sources;
    sources.vertex.addFile(harnessShader("plain_vertex.glsl"));
    sources.fragment.addFile(harnessShader("camera.glsl"));
    sources.fragment.addFile(harnessShader("nearest_polygon_main.glsl"));
    return sources;
}

StageSources reliefLightSources(const Technique& technique, Side side) {
    return reliefStages(technique, side, std::nullopt);
}

const std::set<std::string>& harnessNames() {
    static const std::set<std::string> names = [] {
        constexpr size_t kAnyLights = 1;
        const HarnessUse all = useOfAll();
        std::set<std::string> found = fileScopeNames(reliefHarness(all, kAnyLights).assemble());
        found.merge(fileScopeNames(reliefHarness(all, std::nullopt).assemble()));
        return found;
    }();
    return names;
}

} // namespace plumbline
