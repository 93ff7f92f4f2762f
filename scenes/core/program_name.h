// Name and version of the program, as every file it writes states them.
#pragma once

#include <string>

namespace plumbline {

/// "plumbline 0.1.0".
std::string programName();

} // namespace plumbline
