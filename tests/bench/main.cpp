// ./plumbline bench [--section=NAME] [Google Benchmark's options]: whole processes, baked maps, the metrics
// of a pair of frames, the overhead of the harness, the cost of a report, and the stages of the reference
// with their ratios to bare libraries.
#include "scenes/scene_file/scene_library.h"
#include "tests/bench/bake_bench.h"
#include "tests/bench/harness_bench.h"
#include "tests/bench/metrics_bench.h"
#include "tests/bench/process_bench.h"
#include "tests/bench/report_bench.h"
#include "tests/bench/stage_bench.h"
#include "tests/temporary_folder.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using plumbline::ProcessResult;
using plumbline::runProcess;
using plumbline::StageResult;
using plumbline::TemporaryFolder;

constexpr double kValidateSecondsAim = 30; // every technique on every surface

/// A run of the reference at one rate: a torus cage of `around` x 8 faces, and the goals on two cores. (For
/// comparison, Blender 3.4 Cycles takes 6.0 s and 1.47 GB for 4.2 M micro-triangles, 20.2 s and 4.87 GB
/// for 16.8 M.)
struct ReferenceRun {
    int around, rate;
    const char* aim;
    double microTriangles() const { return around * 8.0 * 2 * rate * rate; }
};
constexpr ReferenceRun kReferenceRuns[] = {{16, 64, "none"},
                                           {16, 128, "0.8 s, 150 MB"},
                                           {16, 256, "2.5 s, 450 MB"},
                                           {16, 512, "none"},
                                           {24, 512, "finishes, 2500 MB"}};

void printRatios(const std::map<std::string, StageResult>& stages) {
    fmt::print("\n{:<20}{:>14}{:>14}{:>12}{:>12}{:>16}{:>14}{:>16}\n", "stone_torus, rate", "tessellated",
               "of bare Bfr", "BVH build", "rays", "of bare Embree", "whole frame", "of bare Embree");
    for (const int rate : {64, 128, 256}) {
        const auto at = [&](const char* stage) {
            const auto found = stages.find(fmt::format("{}/{}", stage, rate));
            return found == stages.end() ? StageResult{} : found->second;
        };
        if (at("tessellate").realMs == 0 || at("trace").realMs == 0 || at("rays").realMs == 0)
            continue; // filtered out
        fmt::print("{:<20}{:>10.1f} M/s{:>13.0f}%{:>9.0f} ms{:>8.2f} M/s{:>15.0f}%{:>10.2f} M/s{:>15.0f}%\n",
                   rate, at("tessellate").itemsPerSecond * 1e-6, 100 * at("tessellate").ofBare,
                   at("embree_build").realMs, at("rays").itemsPerSecond * 1e-6, 100 * at("rays").ofBare,
                   at("trace").itemsPerSecond * 1e-6, 100 * at("trace").ofBare);
    }
}

bool printProcess(const std::string& title, const ProcessResult& result, const std::string& aim) {
    if (result.exitCode != 0) {
        fmt::print("{:<44} failed with exit code {}\n", title, result.exitCode);
        return false;
    }
    fmt::print("{:<44}{:>8.2f} s{:>8.0f} MB   ({} runs, median; aim {})\n", title, result.wallSeconds,
               result.peakMegabytes, result.runs, aim);
    return true;
}

/// The library's stone_torus with the given number of faces around.
std::string writeTorus(const std::filesystem::path& folder, int around) {
    std::ifstream library(plumbline::findScene("stone_torus"));
    std::string text((std::istreambuf_iterator<char>(library)), std::istreambuf_iterator<char>());
    const std::string segments = "segments = [16, 8]";
    const size_t at = text.find(segments);
    if (at == std::string::npos) throw std::runtime_error("stone_torus has no '" + segments + "'");
    text.replace(at, segments.size(), fmt::format("segments = [{}, 8]", around));
    const std::filesystem::path file = folder / fmt::format("torus_{}.toml", around);
    std::ofstream(file) << text;
    return file.string();
}

/// Cost per additional micro-triangle, from each size to the next; constant if the cost is linear.
void printCurve(const ProcessResult& coarsest,
                const std::vector<std::pair<ReferenceRun, ProcessResult>>& curve) {
    fmt::print("\n{:<44}{:>14}{:>18}\n", "from … to", "ns/triangle", "bytes/triangle");
    ProcessResult before = coarsest;
    double triangles = 16 * 8 * 2 * 64.0;
    for (const auto& [run, result] : curve) {
        const double more = run.microTriangles() - triangles;
        fmt::print("{:<44}{:>14.0f}{:>18.1f}\n",
                   fmt::format("{:.1f} M to {:.1f} M", triangles * 1e-6, run.microTriangles() * 1e-6),
                   (result.wallSeconds - before.wallSeconds) / more * 1e9,
                   (result.peakMegabytes - before.peakMegabytes) * (1 << 20) / more);
        before = result;
        triangles = run.microTriangles();
    }
    fmt::print("\n");
}

void printTechniques(const std::filesystem::path& resultsFile) {
    std::ifstream stream(resultsFile);
    const nlohmann::json results = nlohmann::json::parse(stream);
    const double microTriangles = results.at("reference").at("micro_triangles");
    fmt::print("\n{:<32}{:>12}   timer\n", "technique (stone_torus)", "ms/frame");
    for (const auto& technique : results.at("techniques")) {
        if (!technique.contains("cost") || !technique.at("cost").contains("ms_median")) continue;
        fmt::print("{:<32}{:>12.1f}   {}, {}\n", technique.at("name").get<std::string>(),
                   technique.at("cost").at("ms_median").get<double>(),
                   technique.at("cost").at("timer").get<std::string>(),
                   technique.at("gl").at("renderer").get<std::string>());
    }
    fmt::print("{:<32}{:>12.0f}\n", "micro-triangles", microTriangles);
}

void printProcesses() {
    const TemporaryFolder folder;
    const std::string program = PLUMBLINE_PROGRAM;
    const std::string frame = (folder.path() / "frame.exr").string(),
                      output = (folder.path() / "validate").string();
    fmt::print("\nwhole processes\n");
    const auto reference = [&](const ReferenceRun& run, int runs) {
        const std::string file = writeTorus(folder.path(), run.around);
        return runProcess(
            {program, "reference", file, "-o", frame, "--rate", std::to_string(run.rate), "--memory", "4G"},
            runs);
    };
    const ProcessResult coarsest = reference({16, 8, ""}, 3);
    std::vector<std::pair<ReferenceRun, ProcessResult>> curve;
    for (const ReferenceRun& run : kReferenceRuns) {
        curve.emplace_back(run, reference(run, run.rate < 512 ? 5 : 3));
        printProcess(fmt::format("reference, {:.1f} M micro-triangles, rate {}", run.microTriangles() * 1e-6,
                                 run.rate),
                     curve.back().second, run.aim);
    }
    printCurve(coarsest, curve);
    for (const char* scene : {"pyramid_plane", "stone_torus"}) {
        const ProcessResult validate = runProcess({program, "validate", scene, "-o", output}, 3);
        if (printProcess(fmt::format("validate {}, all techniques", scene), validate,
                         fmt::format("{} s", kValidateSecondsAim)) &&
            std::string(scene) == "stone_torus")
            printTechniques(folder.path() / "validate" / "results.json");
    }
}

constexpr const char* kSections[] = {"processes", "bakes",  "metrics", "harness",
                                     "surfaces",  "report", "stages"};

/// Removes --section=NAME from the arguments and returns NAME; empty: all. Throws for an unknown name.
std::string takeSection(int& argc, char** argv) {
    const std::string option = "--section=";
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument.rfind(option, 0) != 0) continue;
        const std::string name = argument.substr(option.size());
        if (std::find(std::begin(kSections), std::end(kSections), name) == std::end(kSections))
            throw std::runtime_error(
                fmt::format("--section={}; expected one of {}", name, fmt::join(kSections, ", ")));
        std::copy(argv + i + 1, argv + argc, argv + i);
        --argc;
        return name;
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::string only = takeSection(argc, argv);
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
        const auto wanted = [&](const char* section) { return only.empty() || only == section; };
        // First, while this process uses little memory, because a child's peak memory starts at that of its
        // parent.
        if (wanted("processes")) printProcesses();
        if (wanted("bakes")) plumbline::printBakes();
        if (wanted("metrics")) plumbline::printMetrics();
#ifdef PLUMBLINE_GL
        if (wanted("harness")) plumbline::printHarness();
        if (wanted("surfaces")) plumbline::printSurfaces();
        if (wanted("report")) plumbline::printReport();
#endif
        if (wanted("stages")) {
            plumbline::registerStageBenchmarks();
            printRatios(plumbline::runStageBenchmarks());
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench: {}\n", error.what());
        return 1;
    }
}
