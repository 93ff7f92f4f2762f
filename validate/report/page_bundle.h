// The page's script and style, bundled from page/src when the program is built and held in the program.
#pragma once

#include <string_view>

namespace plumbline::report {

/// Empty in a program built without Node, whose reports are plain pages without scripts.
std::string_view pageScript();
/// For both kinds of page.
std::string_view pageStyle();

/// Why reports are plain, a sentence; empty if they aren't.
std::string_view plainReportReason();

} // namespace plumbline::report
