#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/parsed_option.h"
#include "validate/results/history_moves.h"
#include "validate/results/number_text.h"
#include "validate/results/output_files.h"
#include "validate/results/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

struct Arguments {
    std::filesystem::path file;
    std::vector<std::filesystem::path> results; // results.json, oldest first
    std::optional<std::string> label;           // of all of them
    Tolerances tolerances;
    bool dryRun = false; // the file stays as it is
};

struct History {
    std::string text; // as in the file; empty if there is none yet
    std::vector<HistoryRecord> records;
};

/// Those of the results, oldest first.
std::vector<HistoryRecord> readResults(const Arguments& arguments) {
    std::vector<HistoryRecord> records;
    for (const std::filesystem::path& file : arguments.results)
        records.push_back(recordOf(file.string(), readWholeFile(file), arguments.label));
    return records;
}

/// Of two runs that read the history and replace it at once, one would lose the other's records.
FileLock lockHistory(const std::filesystem::path& file) {
    constexpr std::chrono::seconds kUntilMessage(1), kLimit(60); // an addition takes milliseconds
    const std::filesystem::path target = linkTarget(file);
    const auto lockFor = [&](std::chrono::milliseconds wait) {
        return FileLock::acquire(folderOf(target), target.filename(), LockKind::Exclusive, wait);
    };
    if (auto lock = lockFor(kUntilMessage)) return std::move(*lock);
    fmt::print(stderr, "{}: waiting for another run that is adding to it\n", file.string());
    if (auto lock = lockFor(kLimit)) return std::move(*lock);
    throw MachineError(file.string(),
                       fmt::format("another run has been adding to it for {} s", kLimit.count()),
                       "one that ends");
}

/// A missing or empty file is a history without records, if there is something to put in.
History readOrBegin(const Arguments& arguments) {
    std::error_code error;
    const bool begins = !std::filesystem::exists(arguments.file, error) ||
                        (std::filesystem::is_regular_file(arguments.file, error) &&
                         std::filesystem::file_size(arguments.file, error) == 0);
    History history;
    if (begins && !arguments.results.empty()) return history;
    history.text = readWholeFile(arguments.file);
    history.records = readHistory(arguments.file.string(), history.text);
    return history;
}

std::string parseLabel(const std::string& label) {
    constexpr size_t kLongest = 200;
    if (label.empty() || label.size() > kLongest || printable(label) != label)
        throw InputError("--label", fmt::format("is {} bytes long or more than one line", label.size()),
                         "a text of 1 to 200 bytes, for example a commit");
    return label;
}

/// Whether they are of one run: all but the label.
bool sameRun(HistoryRecord a, const HistoryRecord& b) {
    a.label = b.label;
    return a == b;
}

/// Adds the results but those that are the latest of their scene already; returns their scenes.
std::vector<std::string> append(History& history, const std::vector<HistoryRecord>& records,
                                const Arguments& arguments) {
    if (!history.text.empty() && !history.text.ends_with('\n')) history.text += '\n';
    std::vector<std::string> scenes;
    for (size_t i = 0; i < records.size(); ++i) {
        const HistoryRecord& record = records[i];
        scenes.push_back(record.scene);
        const auto latest =
            std::find_if(history.records.rbegin(), history.records.rend(),
                         [&](const HistoryRecord& other) { return other.scene == record.scene; });
        if (latest != history.records.rend() && sameRun(*latest, record)) {
            fmt::print("{}: nothing new, it is record {} ('{}')\n", arguments.results[i].string(),
                       history.records.rend() - latest, latest->label);
            continue;
        }
        history.text += toLine(record);
        history.records.push_back(record);
    }
    return scenes;
}

std::string shown(const std::optional<double>& value) {
    return value ? numberText("{:.6g}", *value) : "-";
}

const char* nameOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Better:
        return "better";
    case Verdict::Tolerated:
        return "worse, tolerated";
    case Verdict::Regression:
        return "regression";
    case Verdict::Neutral:
        break;
    }
    return "";
}

void print(const SceneMoves& scene) {
    if (scene.before.empty())
        fmt::print("{}: {}\n", scene.scene, scene.after);
    else
        fmt::print("{}: from {} to {}\n", scene.scene, scene.before, scene.after);
    TextTable table({"technique", "figure", "before", "after", "change", ""});
    for (const FigureMove& move : scene.moves)
        table.add({move.technique, move.figure, shown(move.before), shown(move.after),
                   move.before && move.after ? fmt::format("{:+.3g}", *move.after - *move.before) : "-",
                   nameOf(move.verdict)});
    if (!table.empty()) fmt::print("{}", table.text());
    for (const auto& [technique, count] : scene.unmoved)
        fmt::print("{}: {} figures as before\n", technique, count);
    for (const std::string& note : scene.notes)
        fmt::print("note: {}\n", note);
    for (const std::string& failure : scene.failures)
        fmt::print(stderr, "regression: {}: {}\n", scene.scene, failure);
    for (const FigureMove& move : scene.moves)
        if (move.verdict == Verdict::Regression)
            fmt::print(stderr, "regression: {}: {}: {} from {} to {}; tolerated {:.3g}\n", scene.scene,
                       move.technique, move.figure, shown(move.before),
                       move.after ? shown(move.after) : "no value", move.tolerated);
}

/// Adds the results to the history in the file, unless that is to stay as it is; returns their scenes.
std::vector<std::string> update(History& history, const Arguments& arguments) {
    const std::vector<HistoryRecord> records = readResults(arguments);
    std::optional<FileLock> lock; // while it is read and replaced
    if (!records.empty() && !arguments.dryRun) {
        requireWritableFile(arguments.file, arguments.results);
        lock.emplace(lockHistory(arguments.file));
    }
    history = readOrBegin(arguments);
    const size_t known = history.records.size();
    std::vector<std::string> scenes = append(history, records, arguments);
    if (lock && history.records.size() > known) replaceFile(arguments.file, history.text);
    return scenes;
}

/// kExitThreshold if a figure is worse than tolerated.
int runHistory(const Arguments& arguments) {
    History history;
    const std::vector<std::string> scenes = update(history, arguments);
    bool regression = false;
    for (const SceneMoves& scene : latestMoves(history.records, scenes, arguments.tolerances)) {
        print(scene);
        regression |= scene.hasRegression();
    }
    return regression ? kExitThreshold : kExitDone;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("FILE", arguments->file, "The history, one line per run; created if missing")
        ->required();
    command.add_option("RESULTS", arguments->results,
                       "results.json files to add, oldest first; none: compare only");
    addParsed(command, "--label", arguments->label, parseLabel,
              "Label of the results, for example a commit (default: the program's version)")
        ->type_name("TEXT");
    addParsed<std::vector<std::string>>(
        command, "--tolerance", arguments->tolerances, Tolerances::parse,
        "How much worse a figure may become, for example silhouette.iou=0.001, depth.rmse=2% or all=1%; may "
        "be "
        "repeated. Default: 0, or the interval of a figure that has one; cost isn't limited")
        ->type_name("FIGURE=AMOUNT")
        ->allow_extra_args(false);
    command.add_flag("--dry-run", arguments->dryRun, "Compare without changing FILE");
    return [arguments] { return runHistory(*arguments); };
}

} // namespace

Command historyCommand() {
    return {"history", "Store results of a shader under test and report regressions (exit code 1)",
            addOptions};
}

} // namespace plumbline
