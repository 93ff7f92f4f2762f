#include "tests/bench/harness_bench.h"

#include "realtime/draw/baked_input.h"
#include "realtime/draw/frame_target.h"
#include "realtime/draw/gpu_scene.h"
#include "realtime/draw/technique_program.h"
#include "realtime/draw/view.h"
#include "realtime/realtime.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <unistd.h>

namespace plumbline {
namespace {

constexpr int kRuns = 15;

/// One float target, the smallest that stores the result of a search.
class BareTarget {
  public:
    BareTarget(int width, int height) : framebuffer_(GlFramebuffer::make()), width_(width), height_(height) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
        const auto attach = [&](GlTexture& texture, GLint format, GLenum components, GLenum attachment) {
            texture = GlTexture::make();
            glBindTexture(GL_TEXTURE_2D, texture.get());
            glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, components, GL_FLOAT, nullptr);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.get(), 0);
        };
        attach(color_, GL_RGBA32F, GL_RGBA, GL_COLOR_ATTACHMENT0);
        attach(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_DEPTH_ATTACHMENT);
        checkGl("the bare shader's target");
    }
    void begin() const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
        glViewport(0, 0, width_, height_);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

  private:
    GlFramebuffer framebuffer_;
    GlTexture color_, depth_;
    int width_, height_;
};

std::string without(std::string text, const std::string& piece) {
    for (size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at))
        text.erase(at, piece.size());
    return text;
}

/// The file without counters.
void addUncounted(ShaderSource& source, const std::filesystem::path& file) {
    std::string text = readWholeFile(file);
    for (const char* count :
         {"++gHeightLookups;", "++gBakedLookups;", "gBakedLookups += 4;", "++gIterations;"})
        text = without(text, count);
    source.addText(file.string(), text);
}

/// The search and its surface alone: no normal, shading, shadows, channels or counters.
StageSources bareSources(const Technique& technique) {
    StageSources sources;
    ShaderSource& fragment = sources.fragment;
    sources.vertex.addFile(harnessShader("proxy_vertex.glsl"));
    fragment.addText("(settings)",
                     fmt::format("const bool kHardwareFilter = {};\nconst bool kFromBehind = false;\n"
                                 "layout(location = 0) out vec4 outHit;\n",
                                 technique.hardwareFilter()));
    fragment.addFile(harnessShader("camera.glsl"));
    for (const char* name :
         {"height_map.glsl", "relief_contract.glsl", "relief_side.glsl", "relief_walk.glsl"})
        addUncounted(fragment, harnessShader(name));
    if (technique.surface->hasOffer("bounded_descent"))
        addUncounted(fragment, harnessShader("relief_descent.glsl"));
    for (const std::string& kind : technique.bakedKinds())
        addUncounted(fragment, harnessShader(bakedFamily(kind).shader));
    fragment.addFile(harnessShader("relief_frame.glsl"));
    fragment.addText(
        "(main)",
        "void main() {\n"
        "    ReliefFrame frame = fragmentFrame();\n"
        "    ReliefRay ray;\n"
        "    vec3 direction = reliefDirection(frame, -directionToCamera(vPosition));\n"
        "    if (!enterRelief(frame, frame.st, direction, ray)) discard;\n"
        "    ReliefHit hit = traceRelief(ray);\n"
        "    if (!hit.hit) discard;\n"
        "    outHit = vec4(hit.t, hit.st, 1.0);\n"
        "    gl_FragDepth = clamp((planarDepth(vPosition) - uDepthRange.x) * uDepthRange.y, 0.0, 1.0);\n"
        "}\n");
    if (technique.hasCurvedBase()) fragment.addFile(harnessShader("quadric_base.glsl"));
    fragment.addText("(parameters)", technique.glslConstants());
    fragment.addFile(technique.surface->shaderFile());
    fragment.addFile(technique.search.shaderFile());
    return sources;
}

std::unique_ptr<GlProgram> buildBareProgram(const Technique& technique) {
    const StageSources sources = bareSources(technique);
    return std::make_unique<GlProgram>(sources.vertex, sources.fragment);
}

/// Number of instructions in the functions of the optimized shader; 0 if the tools aren't installed.
/// Declarations and labels aren't counted.
int instructionCount(const ShaderSource& source) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("plumbline-bench-{}.frag", ::getpid());
    std::ofstream(file) << source.assemble("450");
    const std::string command =
        fmt::format("f={0}; glslangValidator -G --aml --amb -o $f.spv $f >/dev/null 2>&1 && spirv-opt -O "
                    "$f.spv -o $f.opt && "
                    "spirv-dis $f.opt | sed '1,/OpFunction/d' | grep -cvE "
                    "'Op(Label|Variable|FunctionEnd|SelectionMerge|LoopMerge|Line|NoLine)'; "
                    "rm -f $f $f.spv $f.opt",
                    file.string());
    FILE* pipe = ::popen(command.c_str(), "r");
    int count = 0;
    const bool read = pipe && std::fscanf(pipe, "%d", &count) == 1;
    if (pipe) ::pclose(pipe);
    return read ? count : 0;
}

class Harness {
  public:
    Harness()
        : scene_(readScene(findScene("stone_torus"))), context_(createGlContext({})), current_(*context_),
          objects_(scene_, *context_), view_(scene_, objects_.boundsWorld()), target_(scene_, *context_),
          bare_(scene_.camera.width, scene_.camera.height) {
        objects_.upload(view_.originWorld());
    }
    std::string renderer() const { return context_->renderer(); }

    struct Times {
        double fullMs, bareMs;
    };
    /// Medians of frames drawn alternately with harness and bare shader, technique by technique.
    std::vector<Times> times(const std::vector<std::string>& texts) {
        struct Entry {
            Technique technique;
            std::unique_ptr<GlProgram> full, bare;
            std::vector<double> fullMs, bareMs;
        };
        std::vector<Entry> entries;
        for (const std::string& text : texts) {
            Technique technique = resolveTechnique(text);
            auto full = buildReliefProgram(technique, scene_.lights.size()),
                 bare = buildBareProgram(technique);
            entries.push_back({std::move(technique), std::move(full), std::move(bare), {}, {}});
        }
        for (int run = 0; run <= kRuns; ++run)
            for (Entry& entry : entries) {
                objects_.prepareBaked(entry.technique);
                if (entry.technique.hasCurvedBase()) objects_.useCurvature(entry.technique.curvatureSet());
                const double full = milliseconds([&] { target_.begin(), draw(*entry.full); });
                const double bare = milliseconds([&] { bare_.begin(), draw(*entry.bare); });
                if (run == 0) continue; // the driver compiles
                entry.fullMs.push_back(full);
                entry.bareMs.push_back(bare);
            }
        std::vector<Times> result;
        for (const Entry& entry : entries)
            result.push_back({median(entry.fullMs), median(entry.bareMs)});
        return result;
    }

  private:
    void draw(const GlProgram& program) {
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        program.use();
        view_.setUniforms(program);
        glUniform1f(program.uniform("uShadowBias"), 0.02f);
        for (size_t i = 0; i < objects_.objects().size(); ++i)
            if (objects_.objects()[i].hasRelief) objects_.draw(i, program);
    }
    static double milliseconds(const std::function<void()>& drawFrame) {
        using Clock = std::chrono::steady_clock;
        glFinish();
        const Clock::time_point start = Clock::now();
        drawFrame();
        glFinish();
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    static double median(std::vector<double> values) {
        std::nth_element(values.begin(), values.begin() + kRuns / 2, values.end());
        return values[kRuns / 2];
    }

    Scene scene_;
    std::unique_ptr<GlContext> context_;
    CurrentContext current_;
    GpuScene objects_;
    View view_;
    FrameTarget target_;
    BareTarget bare_;
};

} // namespace

void printHarness() try {
    Harness harness;
    fmt::print("\nharness and bare shader, stone_torus, {}; no shadows\n", harness.renderer());
    fmt::print("{:<40}{:>12}{:>10}{:>16}{:>14}{:>8}\n", "technique", "harness ms", "bare ms",
               "search in it ms", "in bare ms", "ratio");
    // Time of both without a search: vertices, the ray, and in the harness normal, shading and channels.
    const Harness::Times none = harness.times({"normal_mapping"})[0];
    fmt::print("{:<40}{:>12.2f}{:>10.2f}\n", "normal_mapping (no search)", none.fullMs, none.bareMs);
    for (const char* technique :
         {"linear_binary:linear_steps=64", "linear_secant:linear_steps=64", "cone_step:cone_steps=60",
          "cone_step_relaxed:cone_steps=60", "sphere_tracing", "max_mipmap", "exact_cells"}) {
        const std::string text = technique;
        const char* separator = text.find(':') == std::string::npos ? ":" : ",";
        const Harness::Times both = harness.times({text + separator + "shadow=none"})[0];
        const double inHarness = both.fullMs - none.fullMs, inBare = both.bareMs - none.bareMs;
        fmt::print("{:<40}{:>12.2f}{:>10.2f}{:>16.2f}{:>14.2f}{:>8.2f}\n", technique, both.fullMs,
                   both.bareMs, inHarness, inBare, inHarness / inBare);
    }
    fmt::print("ratio: the search's own time in the harness to that in the bare shader (aim 1.10)\n");
} catch (const MachineError& error) {
    fmt::print("\nharness and bare shader: not measured: {}\n", error.what());
}

void printSurfaces() try {
    Harness harness;
    const std::vector<std::string> surfaces{"flat", "quadric", "quadric_full", "quadric_perpendicular",
                                            "quadric_nearest"};
    fmt::print("\nsurfaces under linear_binary, 64 + 6, stone_torus, {}; no shadows; drawn in turn\n",
               harness.renderer());
    fmt::print("{:<26}{:>10}{:>12}{:>10}{:>14}\n", "surface", "lookups", "harness ms", "bare ms",
               "instructions");
    for (const char* filter : {"exact", "hardware"}) {
        std::vector<std::string> texts;
        for (const std::string& surface : surfaces)
            texts.push_back(
                fmt::format("linear_binary@{}:linear_steps=64,shadow=none,filter={}", surface, filter));
        const std::vector<Harness::Times> times = harness.times(texts);
        for (size_t i = 0; i < surfaces.size(); ++i) {
            const int count = instructionCount(bareSources(resolveTechnique(texts[i])).fragment);
            fmt::print("{:<26}{:>10}{:>12.2f}{:>10.2f}{:>14}\n", surfaces[i], filter, times[i].fullMs,
                       times[i].bareMs, count > 0 ? std::to_string(count) : "-");
        }
        fmt::print("{:<26}{:>10}{:>12.2f}{:>10.2f}\n", "Eq. 6 / Eq. 7", filter,
                   times[3].fullMs / times[1].fullMs, times[3].bareMs / times[1].bareMs);
    }
    fmt::print("instructions: of the bare fragment shader as SPIR-V, optimized (glslangValidator, "
               "spirv-opt); - without these\n");
} catch (const MachineError& error) {
    fmt::print("\nsurfaces: not measured: {}\n", error.what());
}

} // namespace plumbline
