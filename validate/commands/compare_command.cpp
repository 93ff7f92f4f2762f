#include "../../scenes/error.h"
#include "../../scenes/frame_exr.h"
#include "../../scenes/replace_file.h"
#include "../../scenes/scene_metadata.h"
#include "../frame_metadata.h"
#include "../output_files.h"
#include "shared.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

std::string metadataOf(const Frame& frame, const std::string& key, const std::string& otherwise) {
    const auto found = frame.metadata.find(key);
    return found == frame.metadata.end() ? otherwise : found->second;
}

ReferenceSummary fromFile(const Frame& frame, const std::string& file) {
    const Figure none = Figure::absent("the reference came from a file");
    ReferenceSummary summary;
    summary.microTriangles = summary.tessellateMs = summary.buildMs = summary.traceMs = summary.peakBytes =
        none;
    summary.certificate = certificateFromHeader(frame, file);
    return summary;
}

Results compareFiles(const CompareArguments& arguments, const Frame& reference, const Frame& test) {
    std::vector<ObjectInfo> objects = objectsFromHeader(reference, arguments.reference.string());
    if (objects.empty()) objects = objectsFromHeader(test, arguments.test.string());
    std::optional<Camera> camera = cameraFromHeader(reference, arguments.reference.string());
    if (!camera) camera = cameraFromHeader(test, arguments.test.string());

    Results results;
    results.program = programName();
    results.scene = {metadataOf(reference, "scene", arguments.reference.stem().string()),
                     "",
                     metadataOf(reference, "scene_hash", ""),
                     {},
                     reference.width(),
                     reference.height()};
    if (const std::string base = metadataOf(reference, "base", ""); base == "limit" || base == "proxy")
        results.base = base;
    results.reference = fromFile(reference, arguments.reference.string());
    TechniqueOutcome outcome;
    outcome.name = metadataOf(test, "technique", arguments.test.stem().string());
    outcome.msMedian = Figure::absent("the frame came from a file");
    outcome.comparison = compareFrames(reference, test, objects, camera);
    results.techniques.push_back(std::move(outcome));
    return results;
}

void writeComparison(const CompareArguments& arguments, const Results& results, const Frame& reference,
                     const Frame& test) {
    const std::filesystem::path folder = *arguments.output;
    Report report(folder / "report", reportOptions(arguments.report));
    report.addReference(reference);
    report.addTechnique(results.techniques[0], reference, test);
    replaceFile(folder / "results.json", toJson(results));
    replaceFile(folder / "results.csv", toCsv(results));
    report.write(results);
}

} // namespace

int runCompare(const CompareArguments& arguments) {
    const Frame reference = readFrame(arguments.reference), test = readFrame(arguments.test);
    const Results results = compareFiles(arguments, reference, test);
    if (arguments.output) {
        requireWritableFolder(*arguments.output);
        requireWritableFolder(*arguments.output / "report");
        writeComparison(arguments, results, reference, test);
    }
    if (arguments.json) {
        fmt::print("{}", toJson(results));
        return kExitDone;
    }
    fmt::print("{}", toTable(results));
    for (const std::string& note : results.techniques[0].comparison.notes)
        fmt::print("note: {}\n", note);
    if (arguments.output) fmt::print("{}", reportLine(*arguments.output / "report" / "index.html"));
    return kExitDone;
}

} // namespace plumbline
