// The results of a run, and the two files written from them: results.json (schema 1) and results.csv.
//
// Equal results give equal bytes. Two runs with equal inputs differ only in timings and peak_bytes. An absent
// figure is left out, and its reason is written to the "absent" object of its group. NaN and infinity are
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
    std::vector<std::string> changes; // fields whose values in the scene file were overridden
    int width = 0, height = 0;
};

struct ReferenceSummary {
    Figure microTriangles, tessellateMs, buildMs, traceMs; // absent if the reference was read from a file
    Figure peakBytes;                                      // largest resident set of the process so far
    CertificateSummary certificate;                        // the error of the reference itself
    struct Object {
        std::string name;
        int rate = 0;       // segments per control edge that were used
        int wantedRate = 0; // largest rate of a face that the requested error needs
        uint64_t microTriangles = 0;
    };
    std::vector<Object> objects;
};

struct TechniqueOutcome {
    std::string name;     // search@surface:changed=parameters
    bool control = false; // draws the triangles of the reference; it isn't ranked with the techniques
    std::map<std::string, std::string> parameters; // all parameters, with the values used
    std::string backend, renderer;                 // empty if the frame was read from a file
    RunCost cost;
    int msRuns = 0; // number of times whose median is cost.msMedian
    std::string timer;
    std::vector<std::string> limits;  // known limits, from its manifest
    std::optional<std::string> error; // if set, there are no metrics
    Comparison comparison;
    std::vector<RequirementResult> requirements; // also if the technique failed
    std::optional<Comparison> againstProxy;      // with both bases: compared with the reference on the proxy
};

/// The reference on the proxy, in a run with both bases, and the error that the base alone causes.
struct ProxyReference {
    ReferenceSummary summary;
    Comparison gap; // this reference, as the test frame, compared with that on the limit surface
};

struct Results {
    std::string program;
    SceneSummary scene;
    std::string base; // of `reference`: "limit" or "proxy"; empty if its file doesn't contain it
    ReferenceSummary reference;
    std::optional<ProxyReference> proxy; // if set, `reference` is on the limit surface
    std::vector<TechniqueOutcome> techniques;
};

/// The figures of the whole image and of the technique's run.
MetricSet pooledFigures(const TechniqueOutcome& technique);

/// Pretty-printed, keys in the schema's order, ends with a newline.
std::string toJson(const Results& results);

/// RFC 4180: a header line, then a row for each technique x reference x object x light; object "(pooled)"
/// first. `reference` is the base of the reference that the technique is compared with. With both bases the
/// gap between them comes first, as the technique "(base gap)". Figures of the whole image are in the pooled
/// rows only. Without lights the light is empty; an absent figure is an empty cell; a technique that failed
/// has one row with its error.
std::string toCsv(const Results& results);

/// Plain-text table of the most important pooled figures, for the terminal. "±" is the distance from the
/// figure before it to the farther end of its interval, rounded up. Normals are in degrees, "rel" in relief
/// depths. "require": the number of requirements reached and their total, if there are any. With both bases
/// there is a second table: the gap between the references, and each technique compared with the reference on
/// the proxy.
std::string toTable(const Results& results);

} // namespace plumbline
