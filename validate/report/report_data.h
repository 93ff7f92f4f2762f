// What the page's script is told beside its frames: results, frames there are, curves, ranges. src/data.ts of
// the page has its shape.
#pragma once

#include "validate/report/error_curves.h"
#include "validate/results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::report {

/// A frame the page can show.
struct FrameEntry {
    std::string id;                 // unique, whatever techniques are called
    std::string name;               // of a technique: its name in the results
    const char* kind = "technique"; // reference, proxy, technique, summary
    std::string file;               // relative to the page
    std::vector<std::string> layers;
    std::optional<ErrorCurves> curves = {};
};

/// Full colour of the signed depth error's map, world units: a quarter of the largest relief depth, so that
/// pictures of different techniques and runs compare; without a relief depth, the comparison's own p95 (1 if
/// that is 0).
struct DepthRange {
    double worldUnits = 1;
    std::string note; // how it came about
};
DepthRange depthRange(const Comparison& comparison);

struct ReportData {
    std::vector<FrameEntry> frames; // the reference first
    std::vector<ObjectInfo> objects;
    DepthRange depthRange;
    int failingOf = 0; // techniques counted in the summary's layer "failing"
};

/// JSON that may stand in a script element: it holds no '<'.
std::string reportDataJson(const Results& results, const ReportData& data);

/// A JSON text as it may stand in a script element.
std::string scriptSafe(std::string json);

} // namespace plumbline::report
