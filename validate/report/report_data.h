// The data that the page's script gets beside its frames: results, list of frames, curves, ranges, colors.
// src/data.ts of the page describes its structure.
#pragma once

#include "validate/report/error_curves.h"
#include "validate/results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::report {

/// A frame the page can show.
struct FrameEntry {
    std::string id;                 // unique; names needn't be
    std::string name;               // of a technique: its name in the results
    const char* kind = "technique"; // reference, proxy, technique, summary
    std::string file;               // relative to the page
    std::vector<std::string> layers;
    std::optional<ErrorCurves> curves = {};
};

/// Where the color map of signed depth errors ends, world units: at a quarter of the largest relief depth,
/// so that pictures of different techniques and runs can be compared; without a relief depth, at the
/// comparison's own p95 (1 if that is 0).
struct DepthRange {
    double worldUnits = 1;
    std::string note; // why it ends there
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
