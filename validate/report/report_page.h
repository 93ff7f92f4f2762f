// Renders report/index.html from results and the file names of its images.
#pragma once

#include "validate/results/results.h"

#include <map>
#include <string>
#include <vector>

namespace plumbline {

/// An image of the page; `file` is relative to the page.
struct ReportPicture {
    enum class Kind { Color, Silhouette, DepthError, Shadow, Iterations, Curvature }; // selects the legend
    std::string file, caption;
    Kind kind = Kind::Color;
    /// Depth error: the color map ends at +-range world units; the note gives the reason. Iterations: it ends
    /// at range. Curvature: it ends at +-range.
    std::string range = {}, rangeNote = {};
    std::vector<uint64_t> histogram = {}; // of iterations: number of pixels by number of iterations
};

struct ReportPictures {
    std::string reference;
    std::map<std::string, std::vector<ReportPicture>> techniques; // by name
    std::vector<ReportPicture> baseGap; // the reference on the proxy compared with the limit one
};

/// Data and scripts of an interactive page; all are empty for a plain page.
struct PageScripts {
    std::string data;                          // reportDataJson()
    std::string script;                        // empty if report.js is a file next to the page
    std::map<std::string, std::string> frames; // JSON of frames embedded in the page, by file
};

/// Renders validate/report/page/index.mustache, which includes pictures.mustache. Both escape every text.
/// Throws MachineError if a template is missing.
std::string reportPage(const Results& results, const ReportPictures& pictures, const PageScripts& scripts);

} // namespace plumbline
