// The page's script and style, bundled from page/src when the program was built and held in the program.
#pragma once

#include <string_view>

namespace plumbline::report {

/// Empty in a program that was built without Node: its reports are plain pages without scripts.
std::string_view pageScript();
/// Of both kinds of page.
std::string_view pageStyle();

/// Why reports are plain, a sentence; empty where they aren't.
std::string_view plainReportReason();

} // namespace plumbline::report
