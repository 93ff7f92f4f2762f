#include "tests/bench/report_bench.h"

#include "scenes/frame/object_info.h"
#include "tests/bench/process_bench.h"
#include "tests/read_frame.h"
#include "tests/temporary_folder.h"
#include "validate/report/report.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace plumbline {
namespace {

constexpr double kSecondsAim = 5, kMegabytesAim = 40;
constexpr int kRuns = 5;
constexpr const char* kTechniques[] = {"binary",
                                       "binary@quadric",
                                       "cone_step",
                                       "cone_step@quadric",
                                       "cone_step_relaxed",
                                       "cone_step_relaxed@quadric",
                                       "exact_cells",
                                       "exact_cells@quadric",
                                       "linear",
                                       "linear@quadric",
                                       "linear_binary",
                                       "linear_binary@quadric",
                                       "linear_secant",
                                       "linear_secant@quadric",
                                       "parallax",
                                       "sphere_tracing"};

struct Judged {
    TechniqueOutcome outcome;
    Frame frame;
};

std::vector<Judged> judge(const std::filesystem::path& frames, const Frame& reference) {
    const auto objects = objectsFromHeader(reference, "reference");
    std::vector<Judged> all;
    for (const char* name : kTechniques) {
        Judged judged;
        judged.outcome.name = name;
        judged.frame = readFrame(frames / (safeFileName(name) + ".exr"));
        judged.outcome.comparison = compareFrames(reference, judged.frame, objects, std::nullopt);
        all.push_back(std::move(judged));
    }
    return all;
}

/// As `validate` does, writes the page again after every technique.
double secondsToWrite(const std::filesystem::path& folder, const Frame& reference,
                      const std::vector<Judged>& techniques) {
    std::filesystem::create_directories(folder);
    const auto begin = std::chrono::steady_clock::now();
    Report report(folder, {.interactive = true, .singleFile = false});
    report.addReference(reference);
    Results results;
    results.scene.width = reference.width();
    results.scene.height = reference.height();
    for (const Judged& technique : techniques) {
        report.addTechnique(technique.outcome, reference, technique.frame);
        results.techniques.push_back(technique.outcome);
        report.write(results, results.techniques.size() == techniques.size());
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double megabytesOf(const std::filesystem::path& folder) {
    uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return static_cast<double>(bytes) * 1e-6;
}

} // namespace

void printReport() {
    const TemporaryFolder folder;
    std::vector<std::string> command{PLUMBLINE_PROGRAM, "validate", "stone_torus", "-o",
                                     folder.path().string()};
    for (const char* name : kTechniques)
        command.insert(command.end(), {"--technique", name});
    if (runProcess(command, 1).exitCode != 0) {
        fmt::print("report: 'validate stone_torus' failed\n");
        return;
    }
    const Frame reference = readFrame(folder.path() / "frames" / "reference.exr");
    const std::vector<Judged> techniques = judge(folder.path() / "frames", reference);
    std::vector<double> seconds;
    for (int run = 0; run <= kRuns; ++run) { // the first is a warm-up
        const double taken = secondsToWrite(folder.path() / "again", reference, techniques);
        if (run > 0) seconds.push_back(taken);
    }
    std::sort(seconds.begin(), seconds.end());
    fmt::print("\n{:<44}{:>8.2f} s   ({} runs, median; aim {} s)\n", "report of 16 techniques, stone_torus",
               seconds[seconds.size() / 2], kRuns, kSecondsAim);
    fmt::print("{:<44}{:>8.1f} MB  (aim {} MB)\n", "its folder", megabytesOf(folder.path() / "again"),
               kMegabytesAim);
}

} // namespace plumbline
