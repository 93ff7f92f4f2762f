#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/program_name.h"
#include "scenes/core/replace_file.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/header_fields.h"
#include "scenes/frame/object_info.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/parsed_option.h"
#include "validate/cli/report_arguments.h"
#include "validate/cli/requirements.h"
#include "validate/compare/imported_frame.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

struct Arguments {
    std::filesystem::path reference, test;
    std::vector<ChannelMapping> channelMap;      // validate/compare/imported_frame.h
    std::optional<std::filesystem::path> output; // folder
    bool json = false;
    ReportArguments report;
    RequirementArguments requirements;
};

ReferenceSummary fromFile(const Frame& frame, const std::string& file) {
    const Figure none = Figure::absent("the reference came from a file");
    ReferenceSummary summary;
    summary.microTriangles = summary.tessellateMs = summary.buildMs = summary.traceMs = summary.peakBytes =
        none;
    summary.certificate = certificateFromHeader(frame, file);
    return summary;
}

/// Of the view, from either file's header.
std::optional<Camera> cameraOf(const ImportedFrame& reference, const ImportedFrame& test) {
    std::optional<Camera> camera = cameraFromHeader(reference.frame, reference.file);
    return camera ? camera : cameraFromHeader(test.frame, test.file);
}

/// What the two headers leave open, or say differently.
std::vector<std::string> headerNotes(const ImportedFrame& reference, const ImportedFrame& test) {
    std::vector<std::string> notes;
    for (const ImportedFrame* each : {&reference, &test})
        for (const std::string& field : leftOutFields(each->frame, each->file))
            notes.push_back(
                fmt::format("{}: the header field '{}' doesn't have plumbline's format and is left out",
                            each->file, field));
    const auto differ = [&](const char* key) {
        const std::string a = headerField(reference.frame, key), b = headerField(test.frame, key);
        return !a.empty() && !b.empty() && a != b;
    };
    if (differ(header::kSceneHash))
        notes.emplace_back("the headers of the two frames name different scenes (scene_hash)");
    const auto ofReference = cameraFromHeader(reference.frame, reference.file),
               ofTest = cameraFromHeader(test.frame, test.file);
    if (ofReference && ofTest && *ofReference != *ofTest)
        notes.emplace_back(
            "the headers of the two frames name different cameras: the reference's is used for both");
    return notes;
}

/// Both frames as the channel table has them; returns what was assumed for that.
std::vector<std::string> convertFrames(ImportedFrame& reference, ImportedFrame& test) {
    if (reference.frame.width() != test.frame.width() || reference.frame.height() != test.frame.height())
        return {}; // the camera isn't that of both; compareFrames refuses them
    std::vector<std::string> notes = headerNotes(reference, test);
    const std::optional<Camera> camera = cameraOf(reference, test);
    for (ImportedFrame* each : {&reference, &test})
        for (std::string& note : convertFrame(*each, camera))
            notes.push_back(std::move(note));
    return notes;
}

Results compareFiles(const Arguments& arguments, const ImportedFrame& referenceFile,
                     const ImportedFrame& testFile, const std::vector<std::string>& assumed) {
    const Frame &reference = referenceFile.frame, &test = testFile.frame;
    std::vector<ObjectInfo> objects = objectsFromHeader(reference, referenceFile.file);
    if (objects.empty()) objects = objectsFromHeader(test, testFile.file);

    Results results;
    results.program = programName();
    results.scene = {headerField(reference, header::kScene, arguments.reference.stem().string()),
                     "",
                     headerField(reference, header::kSceneHash),
                     {},
                     reference.width(),
                     reference.height()};
    if (const std::string base = headerField(reference, header::kBase);
        base == baseName(Base::Limit) || base == baseName(Base::Proxy))
        results.base = base;
    results.reference = fromFile(reference, arguments.reference.string());
    TechniqueOutcome outcome;
    outcome.name = headerField(test, header::kTechnique, arguments.test.stem().string());
    outcome.cost.msMedian = Figure::absent("the frame came from a file");
    outcome.comparison = compareFrames(reference, test, objects, cameraOf(referenceFile, testFile));
    std::vector<std::string>& notes = outcome.comparison.notes;
    notes.insert(notes.begin(), assumed.begin(), assumed.end());
    results.techniques.push_back(std::move(outcome));
    return results;
}

void writeComparison(const Arguments& arguments, const Results& results, const Frame& reference,
                     const Frame& test) {
    const std::filesystem::path folder = *arguments.output;
    removeOldResults(folder);
    Report report(folder / "report", arguments.report.options());
    report.addReference(reference);
    report.addTechnique(results.techniques[0], reference, test);
    replaceFile(folder / "results.json", toJson(results));
    replaceFile(folder / "results.csv", toCsv(results));
    report.write(results, true);
}

int runCompare(const Arguments& arguments) {
    if (!arguments.output && (arguments.report.singleFile || arguments.report.plain))
        throw InputError("compare", "--single-file and --plain-report apply to a report, and none is written",
                         "-o DIR, the folder for it");
    const std::vector<Requirement>& requirements = arguments.requirements.require;
    ImportedFrame referenceFile = readImportedFrame(arguments.reference, {});
    ImportedFrame testFile = readImportedFrame(arguments.test, arguments.channelMap);
    std::optional<FileLock> claim;
    if (arguments.output) {
        claim.emplace(claimFolder(*arguments.output));
        requireWritableFolder(*arguments.output / "report");
    }
    const std::vector<std::string> assumed = convertFrames(referenceFile, testFile);
    const Frame &reference = referenceFile.frame, &test = testFile.frame;
    Results results = compareFiles(arguments, referenceFile, testFile, assumed);
    checkNames(requirements, results.techniques[0]);
    const int exitCode = holdRequirements(requirements, results.techniques[0]) ? kExitDone : kExitThreshold;
    if (arguments.output) writeComparison(arguments, results, reference, test);
    if (arguments.json) {
        fmt::print("{}", toJson(results));
        return exitCode;
    }
    fmt::print("{}", toTable(results));
    for (const std::string& note : results.techniques[0].comparison.notes)
        fmt::print("note: {}\n", printable(note));
    if (arguments.output) fmt::print("{}", reportLine(*arguments.output / "report" / "index.html"));
    return exitCode;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("REFERENCE", arguments->reference, "The reference frame, EXR")->required();
    command.add_option("TEST", arguments->test, "The frame to compare with it, EXR")->required();
    command.add_option("-o", arguments->output, "Folder for results and report")->type_name("DIR");
    command.add_flag("--json", arguments->json, "Print results.json instead of the table");
    arguments->report.addTo(command);
    addParsed<std::vector<std::string>>(
        command, "--map", arguments->channelMap, parseChannelMap,
        "Map a channel of TEST to one of ours: Depth.Z=Z, dist=distance (along the ray), "
        "Normal.Y=-N.Z; may be repeated")
        ->type_name("THEIRS=OURS")
        ->allow_extra_args(false);
    arguments->requirements.addTo(command);
    return [arguments] { return runCompare(*arguments); };
}

} // namespace

Command compareCommand() {
    return {"compare", "Compare a frame with a reference frame, of any renderer", addOptions};
}

} // namespace plumbline
