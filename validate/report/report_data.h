// The data of the page's script other than the planes of frames: results, list of frames, curves, ranges,
// colors. page/src/data.ts describes its structure.
#pragma once

#include "validate/report/error_curves.h"
#include "validate/results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::report {

/// A frame that the page can show.
struct FrameEntry {
    std::string id;                 // unique, unlike the name
    std::string name;               // of a technique: its name in the results
    const char* kind = "technique"; // reference, proxy, technique, summary
    std::string file;               // relative to the page
    std::vector<std::string> layers;
    std::optional<ErrorCurves> curves = {};
};

/// The range of the color map of signed depth errors, in world units: a quarter of the largest relief depth,
/// so that images of different techniques and runs can be compared; without a relief depth, the p95 of the
/// comparison (1 if that is 0).
struct DepthRange {
    double worldUnits = 1;
    std::string note; // reason for the range
};
DepthRange depthRange(const Comparison& comparison);

struct ReportData {
    std::vector<FrameEntry> frames; // the reference first
    std::vector<ObjectInfo> objects;
    DepthRange depthRange;
    int failingOf = 0; // techniques counted in the summary's layer "failing"
};

/// JSON that is safe in a script element: it contains no '<'.
std::string reportDataJson(const Results& results, const ReportData& data);

/// A JSON text made safe for a script element.
std::string scriptSafe(std::string json);

} // namespace plumbline::report
