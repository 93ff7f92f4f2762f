// A run's outcome in memory, and the two files it becomes: results.json (schema 1) and results.csv.
//
// Equal results give equal bytes; of two runs over equal inputs only timings and peak_bytes differ. A figure
// that is absent is left out, and its reason stands in the neighboring "absent" object; NaN and infinity are
// never written.
#pragma once

#include "validate/compare/compare.h"
#include "validate/metrics/run_cost.h"
#include "validate/results/certificate.h"
#include "validate/results/requirement.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kResultsSchema = 1;

struct SceneSummary {
    std::string name, purpose, hash;
    std::vector<std::string> changes; // fields given other values than the file's
    int width = 0, height = 0;
};

struct ReferenceSummary {
    Figure microTriangles, tessellateMs, buildMs, traceMs; // absent where the reference came from a file
    Figure peakBytes;                                      // largest resident set of the process so far
    CertificateSummary certificate;                        // its own error
    struct Object {
        std::string name;
        int rate = 0;       // segments per control edge taken
        int wantedRate = 0; // the largest of a face for the error aimed at
        uint64_t microTriangles = 0;
    };
    std::vector<Object> objects;
};

struct TechniqueOutcome {
    std::string name;     // search@surface:changed=parameters
    bool control = false; // it draws the reference's own triangles: no technique to compete with
    std::map<std::string, std::string> parameters; // all, with the values used
    std::string backend, renderer;                 // empty where the frame came from a file
    RunCost cost;
    int msRuns = 0; // of which cost.msMedian is the median
    std::string timer;
    std::vector<std::string> limits;  // known ones, from its manifest
    std::optional<std::string> error; // set: no metrics
    Comparison comparison;
    std::vector<RequirementResult> requirements; // what it was to reach; also of one that failed
    std::optional<Comparison> againstProxy;      // with both bases: held against the reference on the proxy
};

/// The reference on the proxy, where a run has one beside that on the limit surface, and what the base alone
/// does.
struct ProxyReference {
    ReferenceSummary summary;
    Comparison gap; // this reference held, as if it were a technique's frame, against the other
};

struct Results {
    std::string program;
    SceneSummary scene;
    std::string base; // of `reference`: "limit" or "proxy"; empty where a file doesn't say
    ReferenceSummary reference;
    std::optional<ProxyReference> proxy; // then `reference` is on the limit surface
    std::vector<TechniqueOutcome> techniques;
};

/// Those of the whole picture and of its run.
MetricSet pooledFigures(const TechniqueOutcome& technique);

/// Pretty-printed, keys in the schema's order, ends with a newline.
std::string toJson(const Results& results);

/// RFC 4180, a head line, then a row a technique x reference x object x light; object "(pooled)" first.
/// `reference` is the base of the one held against; with both, the gap between them comes first, as the
/// technique "(base gap)". Figures of the whole picture stand in the pooled rows only. A scene without lights
/// gets rows with an empty light; an absent figure is an empty cell; a technique that failed has one row with
/// its error.
std::string toCsv(const Results& results);

/// Plain-text table of the pooled figures people look at first, for the terminal. "±" is the distance from
/// the figure before it to the farther end of its interval, rounded up. Normals in degrees, "rel" in relief
/// depths. "require": how many requirements are reached of how many, where there are any. With both bases a
/// second table: the gap between the references, and each technique against that on the proxy.
std::string toTable(const Results& results);

} // namespace plumbline
