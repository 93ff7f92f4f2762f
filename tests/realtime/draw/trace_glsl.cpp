#include "tests/realtime/draw/trace_glsl.h"

#include "realtime/technique/stage_sources.h"
#include "realtime/technique/technique_list.h"
#include "tests/realtime/draw/evaluate_glsl.h"
#include "tests/realtime/gl_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline {
namespace {

constexpr size_t kMaxRaysAtOnce = 4096; // a row of a texture

ShaderSource searchSource(const std::string& name, const ReliefPath& path) {
    const Technique technique = resolveTechnique(name);
    ShaderSource source;
    source.addText("(settings)",
                   fmt::format("const bool kHardwareFilter = {};\nconst bool kFromBehind = false;",
                               technique.hardwareFilter()));
    source.addFile(harnessShader("height_map.glsl"));
    source.addFile(harnessShader("relief_contract.glsl"));
    source.addFile(harnessShader("relief_side.glsl"));
    source.addFile(harnessShader("relief_descent.glsl"));
    source.addFile(harnessShader("relief_walk.glsl"));
    source.addFile(harnessShader("quadric_base.glsl"));
    source.addText("(parameters)", technique.glslConstants());
    // Its surfacePosition is bit-identical to that of `flat` if endDepth is 1 and bend 0.
    source.addFile(surfacesFolder() / "quadric" / "quadric.glsl");
    source.addFile(technique.search.shaderFile());
    source.addText(
        "(test)",
        fmt::format(
            "vec4 evaluate(vec4 a) {{\n"
            "  ReliefRay ray = ReliefRay(a.xy, a.zw, {:.9e}, {:.9e}, 1.0, {:.9e}, vec2(1.0), 1.0, "
            "vec4(0.0), vec4(0.0));\n"
            "  ReliefHit hit = traceRelief(ray);\n"
            "  return vec4(hit.hit ? 1.0 : 0.0, hit.t, float(gIterations), float(gHeightLookups));\n}}",
            path.endDepth, path.bend, path.cosine));
    return source;
}

void bindMap(const HeightMap& map, const GlTexture& texture, const GlProgram& program) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.width(), map.height(), 0, GL_RED, GL_FLOAT,
                 map.depths().data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glUniform1i(program.uniform("uHeightMap"), 0);
    glUniform2i(program.uniform("uHeightMapClamps"), map.wrapS() == Wrap::Clamp, map.wrapT() == Wrap::Clamp);
}

/// All t in [0,1] at which the ray crosses a line of texel centers, including both ends, in order.
std::vector<double> crossings(const HeightMap& map, const ReliefLine& line) {
    std::vector<double> places{0, 1};
    for (const int axis : {0, 1}) {
        const int size = axis == 0 ? map.width() : map.height();
        const double start = double(line.st[axis]) * size - 0.5, travel = double(line.stTravel[axis]) * size;
        const double low = std::min(start, start + travel), high = std::max(start, start + travel);
        if (travel != 0)
            for (double k = std::ceil(low); k <= high; ++k)
                places.push_back(std::clamp((k - start) / travel, 0.0, 1.0));
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// gap(x) = c + b x + a x^2 over x in [0,1].
struct Quadratic {
    double a, b, c;
    double at(double x) const { return c + x * (b + x * a); }
};

/// The root between two points with gap > 0 >= gap, bisected to the last bit.
double bisect(const Quadratic& gap, double outside, double inside) {
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (outside + inside);
        (gap.at(middle) > 0 ? outside : inside) = middle;
    }
    return inside;
}

} // namespace

std::vector<TracedHit> traceGlsl(const std::string& technique, const HeightMap& map,
                                 const std::vector<ReliefLine>& lines, const ReliefPath& path) {
    const CurrentContext current(*testContext());
    GlTexture texture = GlTexture::make();
    std::vector<TracedHit> hits;
    for (size_t first = 0; first < lines.size(); first += kMaxRaysAtOnce) {
        std::vector<glm::vec4> arguments;
        for (size_t i = first; i < std::min(first + kMaxRaysAtOnce, lines.size()); ++i)
            arguments.emplace_back(lines[i].st, lines[i].stTravel);
        for (const glm::vec4& value :
             evaluateGlsl(searchSource(technique, path), arguments,
                          [&](const GlProgram& program) { bindMap(map, texture, program); }))
            hits.push_back({value.x == 1, value.y, static_cast<int>(value.z), static_cast<int>(value.w)});
    }
    return hits;
}

TrueTrace trueFirstHit(const HeightMap& map, const ReliefLine& line, const ReliefPath& path) {
    const auto gapAt = [&](double t) {
        return map.depth(Vec2(line.st) + t * Vec2(line.stTravel)) -
               (path.endDepth * t + path.bend * t * (1 - t));
    };
    TrueTrace result{{}, kInfinity};
    const std::vector<double> places = crossings(map, line);
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        const double begin = places[i], way = places[i + 1] - begin;
        const double first = gapAt(begin), middle = gapAt(begin + 0.5 * way), last = gapAt(places[i + 1]);
        const Quadratic gap{2 * (first + last) - 4 * middle, 4 * middle - 3 * first - last, first};
        const auto hitAt = [&](double x) {
            result.hit = TrueHit{begin + x * way, way > 0 ? std::abs(gap.b + 2 * gap.a * x) / way : kInfinity,
                                 result.nearMiss};
            return result;
        };
        if (first <= 0) return hitAt(0);
        const double turn = gap.a > 0 ? -gap.b / (2 * gap.a) : -1;
        if (turn > 0 && turn < 1) {
            if (gap.at(turn) <= 0) return hitAt(bisect(gap, 0, turn));
            result.nearMiss = std::min(result.nearMiss, gap.at(turn));
        }
        if (last <= 0) return hitAt(bisect(gap, 0, 1));
        // A crease of the relief can be a local minimum too.
        result.nearMiss = std::min(result.nearMiss, last);
    }
    if (path.endDepth >= 1) result.hit = TrueHit{1, kInfinity, result.nearMiss};
    return result;
}

} // namespace plumbline
