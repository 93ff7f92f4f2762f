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
    /// Depth error: full colour is at +-range world units, and why there. Iterations: the darkest colour's.
    /// Curvature: full colour is at +-range.
    std::string range = {}, rangeNote = {};
    std::vector<uint64_t> histogram = {}; // iterations: pixels by rounds
};

struct ReportPictures {
    std::string reference;
    std::map<std::string, std::vector<ReportPicture>> techniques; // by name
    std::vector<ReportPicture> baseGap; // of the reference on the proxy, held against the other
};

/// What the interactive page runs on; all empty: a plain page.
struct PageScripts {
    std::string data;                          // reportDataJson()
    std::string script;                        // empty: report.js lies beside the page
    std::map<std::string, std::string> frames; // JSON of frames the page itself holds, by file
};

/// Fills validate/report/page/index.mustache and pictures.mustache in it, which escape every text. Throws
/// MachineError if the template is missing.
std::string reportPage(const Results& results, const ReportPictures& pictures, const PageScripts& scripts);

} // namespace plumbline
