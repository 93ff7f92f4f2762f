// The text of report/index.html from results and the names of the pictures beside it.
#pragma once

#include "validate/results/results.h"

#include <map>
#include <string>
#include <vector>

namespace plumbline {

/// A picture of the page; `file` is relative to it.
struct ReportPicture {
    enum class Kind { Color, Silhouette, DepthError, Shadow, Iterations, Curvature }; // decides the legend
    std::string file, caption;
    Kind kind = Kind::Color;
    /// Depth error: the color map ends at +-range world units, and why there. Iterations: it ends at range.
    /// Curvature: it ends at +-range.
    std::string range = {}, rangeNote = {};
    std::vector<uint64_t> histogram = {}; // of iterations: pixels by their number
};

struct ReportPictures {
    std::string reference;
    std::map<std::string, std::vector<ReportPicture>> techniques; // by name
    std::vector<ReportPicture> baseGap; // the reference on the proxy compared with the other one
};

/// Data and scripts of an interactive page; all empty: a plain page.
struct PageScripts {
    std::string data;                          // reportDataJson()
    std::string script;                        // empty: report.js lies beside the page
    std::map<std::string, std::string> frames; // JSON of frames that the page itself holds, by file
};

/// Fills validate/report/page/index.mustache and pictures.mustache in it, which escape every text. Throws
/// MachineError if the template is missing.
std::string reportPage(const Results& results, const ReportPictures& pictures, const PageScripts& scripts);

} // namespace plumbline
