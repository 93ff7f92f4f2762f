// ./plumbline bench [Google Benchmark's options]: stages of the reference, then whole processes, then what
// follows from both.
#include "process_bench.h"
#include "stage_bench.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using plumbline::ProcessResult;
using plumbline::runProcess;
using plumbline::StageResult;

// The aims of the project, on two cores (Blender 3.4 Cycles, for comparison: 6.0 s and 1.47 GB for the
// reference).
constexpr double kReferenceSecondsAim = 1.5, kReferenceMegabytesAim = 300, kValidateSecondsAim = 10;

struct TemporaryFolder {
    std::filesystem::path path;
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "plumbline-bench-XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("can't make a folder in " + pattern);
        path = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

void printRatios(const std::map<std::string, StageResult>& stages) {
    fmt::print("\n{:<24}{:>14}{:>14}{:>14}{:>16}{:>16}\n", "stone_torus, rate", "tessellated", "of bare Bfr",
               "BVH build", "rays", "of bare Embree");
    for (const int rate : {64, 128, 256}) {
        const auto at = [&](const char* stage) {
            const auto found = stages.find(fmt::format("{}/{}", stage, rate));
            return found == stages.end() ? StageResult{} : found->second;
        };
        if (at("tessellate").realMs == 0 || at("trace").realMs == 0) continue; // filtered out
        fmt::print("{:<24}{:>10.1f} M/s{:>13.0f}%{:>11.0f} ms{:>12.2f} M/s{:>15.0f}%\n", rate,
                   at("tessellate").itemsPerSecond * 1e-6, 100 * at("tessellate").ofBare,
                   at("embree_build").realMs, at("trace").itemsPerSecond * 1e-6, 100 * at("trace").ofBare);
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

void printTechniques(const std::filesystem::path& resultsFile) {
    std::ifstream stream(resultsFile);
    const nlohmann::json results = nlohmann::json::parse(stream);
    const double microTriangles = results.at("reference").at("micro_triangles");
    fmt::print("\n{:<32}{:>12}   timer\n", "technique (stone_torus)", "ms a frame");
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
    const std::string program = PLUMBLINE_PROGRAM, scene = "stone_torus";
    const std::string frame = (folder.path / "frame.exr").string(),
                      output = (folder.path / "validate").string();
    fmt::print("\nwhole processes\n");
    const auto reference = [&](int rate) {
        return runProcess(
            {program, "reference", scene, "-o", frame, "--rate", std::to_string(rate), "--memory", "4G"}, 5);
    };
    const ProcessResult coarse = reference(1), fine = reference(128), finer = reference(256);
    printProcess("reference, rate 128 (4.2 M micro-triangles)", fine,
                 fmt::format("{} s, {} MB", kReferenceSecondsAim, kReferenceMegabytesAim));
    printProcess("reference, rate 256 (16.8 M)", finer, "none yet");
    if (coarse.exitCode == 0 && finer.exitCode == 0)
        fmt::print("{:<44}{:>8.1f}     (rate 256 less rate 1)\n", "peak bytes a micro-triangle",
                   (finer.peakMegabytes - coarse.peakMegabytes) * (1 << 20) / (128.0 * 2 * 256 * 256));
    const ProcessResult validate = runProcess({program, "validate", scene, "-o", output}, 3);
    if (printProcess("validate, all techniques", validate, fmt::format("{} s", kValidateSecondsAim)))
        printTechniques(folder.path / "validate" / "results.json");
}

} // namespace

int main(int argc, char** argv) {
    try {
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
        plumbline::registerStageBenchmarks();
        printRatios(plumbline::runStageBenchmarks());
        printProcesses();
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench: {}\n", error.what());
        return 1;
    }
}
