// The history of a shader under test: a file of one record a run, kept beside the shader. A record is one
// line of JSON, so that versions merge and differ by lines; it holds what results.json says of the whole
// picture, every figure by its dotted name.
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
    std::string error;                     // empty: it didn't fail

    friend bool operator==(const HistoryTechnique&, const HistoryTechnique&) = default;
};

struct HistoryRecord {
    std::string label; // one line; which version this is
    std::string program;
    std::string scene, sceneHash;              // the hash is empty where the frames compared didn't say
    std::string base;                          // "limit", "proxy", "both", or empty where they didn't say
    std::map<std::string, double> certificate; // the reference's own error, "error_px_p99"; what there is
    std::vector<HistoryTechnique> techniques;

    friend bool operator==(const HistoryRecord&, const HistoryRecord&) = default;
};

/// The record of a run. `where`: the file of `resultsJson`, for errors. No `label`: the program's name and
/// version. Throws InputError for what isn't results.json of this schema, and for one without techniques.
HistoryRecord recordOf(const std::string& where, const std::string& resultsJson,
                       const std::optional<std::string>& label);

/// One line with its end. Equal records give equal bytes.
std::string toLine(const HistoryRecord& record);

/// Records of a file, oldest first; empty lines don't count. Throws InputError with the line of what isn't a
/// record.
std::vector<HistoryRecord> readHistory(const std::string& where, const std::string& text);

} // namespace plumbline
