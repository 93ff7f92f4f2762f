// The page's script and style, bundled from page/src when the program is built and embedded in it.
#pragma once

#include <string_view>

namespace plumbline::report {

/// Empty if the program was built without Node; its reports are then plain pages without scripts.
std::string_view pageScript();
/// Style of both kinds of page.
std::string_view pageStyle();

/// Why reports are plain pages, as a sentence; empty if they are interactive.
std::string_view plainReportReason();

} // namespace plumbline::report
