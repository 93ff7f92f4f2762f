// The history of a shader under test: a file with one record per run, stored next to the shader. A record is
// one line of JSON, so that versions of the file can be merged and compared by lines. It contains the figures
// of results.json for the whole image, by their dotted names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kHistorySchema = 1;

struct HistoryTechnique {
    std::string name;                      // as in results.json, unique in a record
    std::map<std::string, double> figures; // finite; "silhouette.iou", "shadow.sun.iou"; empty if it failed
    std::string error;                     // empty if it didn't fail

    friend bool operator==(const HistoryTechnique&, const HistoryTechnique&) = default;
};

struct HistoryRecord {
    std::string label; // names the version; one line
    std::string program;
    std::string scene, sceneHash;              // the hash is empty if the compared frames don't contain it
    std::string base;                          // "limit", "proxy", "both"; empty if they don't contain it
    std::map<std::string, double> certificate; // the known errors of the reference itself, "error_px_p99"
    std::vector<HistoryTechnique> techniques;

    friend bool operator==(const HistoryRecord&, const HistoryRecord&) = default;
};

/// The record of a run. `where`: the file of `resultsJson`, for errors. `label`: nullopt for the program's
/// name and version. Throws InputError if the text isn't a results.json of this schema or has no techniques.
HistoryRecord recordOf(const std::string& where, const std::string& resultsJson,
                       const std::optional<std::string>& label);

/// One line with a line end. Equal records give equal bytes.
std::string toLine(const HistoryRecord& record);

/// Records of a file, oldest first; empty lines are skipped. Throws InputError, with the line, for a line
/// that isn't a record.
std::vector<HistoryRecord> readHistory(const std::string& where, const std::string& text);

} // namespace plumbline
